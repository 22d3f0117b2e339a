"""Elements of SVG drawings as text, for the scripts in this folder."""

INK, SOFT, GRID, FRAME = "#1b2733", "#5b6b7a", "#d5dce3", "#8794a0"


def escaped(text):
    return str(text).replace("&", "&amp;").replace("<", "&lt;")


def element(name, content=None, **attributes):
    """<name .../> or <name ...>content</name>; lengths are rounded to a tenth, `font_size` becomes font-size."""
    rounded = {key.replace("_", "-"): round(v, 1) if isinstance(v, float) else v for key, v in attributes.items()}
    start = f"<{name} " + " ".join(f'{key}="{value}"' for key, value in rounded.items())
    return f"{start}/>" if content is None else f"{start}>{content}</{name}>"


def text(x, y, content, **attributes):
    return element("text", escaped(content), x=x, y=y, **attributes)


def line(x1, y1, x2, y2, **attributes):
    return element("line", x1=x1, y1=y1, x2=x2, y2=y2, **{"stroke": GRID, **attributes})


def rect(x, y, width, height, **attributes):
    return element("rect", x=x, y=y, width=width, height=height, **attributes)


def document(width, height, parts):
    """A drawing on white paper."""
    content = "\n".join(["", rect(0, 0, width, height, fill="#fff"), *parts, ""])
    return element("svg", content, xmlns="http://www.w3.org/2000/svg", viewBox=f"0 0 {width} {height}",
                   width=width, height=height, font_family="Liberation Sans, Arial, sans-serif",
                   font_size=13, fill=INK) + "\n"
