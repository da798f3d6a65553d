"""Being written."""


def operations():
    raise NotImplementedError


def scenes():
    return ()
