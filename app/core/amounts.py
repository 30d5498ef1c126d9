"""Amounts as people write them: counts with what they count, numbers, shares, and how long something takes."""


def counted(number: int, what: str, plural: str = "") -> str:
    """A number and what it counts: "1 run", "2 runs"."""
    return f"{number:,} {what if number == 1 else plural or what + 's'}"


def number(value: float) -> str:
    """*value* for people: whole numbers without a point, others to four digits, thousands apart."""
    if value == int(value):
        return f"{value:,.0f}"
    return f"{value:,.4g}" if abs(value) < 1000 else f"{value:,.1f}"


def exact(value: float) -> str:
    """*value* with all of its digits, as limits need them: thousands apart, and whole numbers without a point."""
    return f"{value:,}".removesuffix(".0")


def percent(share: float | None) -> str:
    """*share* of 1 as a percentage; a dash where there is none."""
    return "–" if share is None else f"{share:.0%}"


def lasting(seconds: float) -> str:
    """How long: "8 s", "2 min 5 s", "3 h 20 min"."""
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60} s"
    return f"{whole // 3600} h {whole % 3600 // 60} min"
