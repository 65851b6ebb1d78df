"""printf() as LCDPrintf() knows it, for the values of Python."""

import re as _re

_CONVERSION = _re.compile(r"%([-+ #0]*)(\*|\d+)?(?:\.(\*|\d+)?)?(?:hh|h|ll|l|L|q|j|z|t)?([a-zA-Z%])")


def _number(value):
    """`value` as something that is counted or measured; a character is its code."""
    if isinstance(value, (str, bytes)):
        return ord(value) if len(value) == 1 else float(value)
    return getattr(value, "value", value)


def _text(value):
    if isinstance(value, (bytes, bytearray)):
        return bytes(value).decode("latin-1")
    return str(value)


def _character(value):
    if isinstance(value, (str, bytes)):
        return _text(value)[:1]
    return chr(int(_number(value)) & 0xFF)


def _convert(kind, value):
    """`value` for the conversion `kind`, and the conversion of Python that prints it."""
    if kind in "di":
        return int(_number(value)), "d"
    if kind in "uxXo":
        # C shows the bits of an int.
        number = int(_number(value))
        return (number if number >= 0 else number & 0xFFFFFFFF), "d" if kind == "u" else kind
    if kind in "eEfFgG":
        return float(_number(value)), kind
    if kind == "c":
        return _character(value), "s"
    if kind == "p":
        return hex(int(_number(value))), "s"
    return _text(value), "s"


def c_format(form, arguments):
    """What printf(form, …) prints.

    Surplus arguments are ignored. A conversion without an argument, or with one that it cannot show, or that C does
    not know, is printed as it stands: the program goes on and its author sees where.
    """
    form = _text(form)
    if "%" not in form:
        return form
    if len(arguments) == 1 and isinstance(arguments[0], (tuple, list)):
        arguments = arguments[0]
    rest = iter(arguments)

    def shown(match):
        flags, width, precision, kind = match.groups()
        if kind == "%":
            return "%"
        if kind not in "diuxXoeEfFgGcps":
            return match[0]
        try:
            if width == "*":
                width = str(int(_number(next(rest))))
            if precision == "*":
                precision = str(max(int(_number(next(rest))), 0))
            value, python_kind = _convert(kind, next(rest))
        except (StopIteration, TypeError, ValueError, OverflowError):
            return match[0]
        has_precision = "." in match[0] and kind != "c"
        return f"%{flags}{width or ''}{'.' + (precision or '0') if has_precision else ''}{python_kind}" % value

    return _CONVERSION.sub(shown, form)
