"""Structure-aware editing of facades (Dang, Ceylan, Neubert and Pauly 2014): grids, proposals, sessions."""
