"""Operations trees: shapes placed, extruded, united, dressed and edited; recorded once, replayed anywhere."""
