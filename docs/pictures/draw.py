"""Draws the pictures of this folder: `python3 docs/pictures/draw.py`. The numbers of the bars are those of docs/performance.md."""

from pathlib import Path

HERE = Path(__file__).parent
INK, FAINT, OURS, OTHERS, PAPER = "#1f2933", "#7b8794", "#c2410c", "#9aa5b1", "#ffffff"


def write(name, width, height, parts):
    """A picture on white paper, so that it can be read on a dark page too."""
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
        'font-family="Helvetica, Arial, sans-serif" font-size="14">\n'
        f'<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto-start-reverse">'
        f'<path d="M0 0 8 4 0 8z" fill="{INK}"/></marker></defs>\n'
        f'<rect width="{width}" height="{height}" rx="6" fill="{PAPER}"/>\n'
    )
    (HERE / name).write_text(head + "\n".join(parts) + "\n</svg>\n")


def text(x, y, words, size=14, color=INK, anchor="middle", style=""):
    return f'<text x="{x}" y="{y}" font-size="{size}" fill="{color}" text-anchor="{anchor}" {style}>{words}</text>'


def line(x1, y1, x2, y2, color=INK, tip=True, width=1.6, dash=""):
    marker = ' marker-end="url(#tip)"' if tip else ""
    dashes = f' stroke-dasharray="{dash}"' if dash else ""
    return f'<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" stroke="{color}" stroke-width="{width}"{marker}{dashes}/>'


def box(x, y, width, height, title, lines, color=INK):
    parts = [
        f'<rect x="{x}" y="{y}" width="{width}" height="{height}" rx="6" fill="none" stroke="{color}" stroke-width="1.6"/>',
        text(x + width / 2, y + 24, title, 15, color, style='font-weight="bold"'),
    ]
    parts += [text(x + width / 2, y + 46 + 18 * i, words, 12.5, FAINT) for i, words in enumerate(lines)]
    return parts


def pipeline():
    parts = []
    parts += box(12, 22, 150, 84, "model", ["URDF, MJCF or TOML:", "masses, joints, frames"])
    parts += box(222, 22, 150, 84, "kane generate", ["derives the equations,", "counts, simplifies"], OURS)
    parts += box(432, 22, 150, 84, "arm.rs", ["straight-line Rust,", "committed beside it"])
    parts += box(642, 22, 150, 84, "control loop", ["PC, microcontroller,", "C and C++ program"])
    parts += [line(x, 64, x + 56, 64) for x in (164, 374, 584)]
    parts.append(f'<path d="M507 108 V136 H297 V110" fill="none" stroke="{FAINT}" stroke-width="1.4" stroke-dasharray="5 4" marker-end="url(#tip)"/>')
    parts.append(text(402, 152, "kane check, in continuous integration: is the file what the model says?", 12.5, FAINT))
    write("pipeline.svg", 804, 166, parts)


def figures():
    """Robot, then inverse and forward dynamics: ours and CasADi's."""
    rows = {}
    for row in (HERE / "../performance.md").read_text().splitlines():
        cells = [cell.strip() for cell in row.strip("|").split("|")]
        if len(cells) == 7 and cells[0] in ("ur5", "panda", "solo12", "talos") and cells[0] not in rows:
            rows[cells[0]] = [int(cells[i]) for i in (1, 2, 5, 6)]
    return rows


def operations():
    names = {"ur5": "UR5 (6)", "panda": "Panda (7)", "solo12": "Solo 12 (18)", "talos": "Talos (38)"}
    parts = [text(14, 24, "Operations of one call; kane's as a part of CasADi's. In brackets: the number of speeds.", 13, INK, "start")]
    for column, title in enumerate(("inverse dynamics", "forward dynamics")):
        left = 110 + 350 * column
        parts.append(text(left, 50, title, 13, INK, "start", 'font-weight="bold"'))
        for i, (robot, counts) in enumerate(figures().items()):
            ours, others = counts[2 * column], counts[2 * column + 1]
            y = 62 + 42 * i
            if column == 0:
                parts.append(text(100, y + 19, names[robot], 13, INK, "end"))
            parts.append(f'<rect x="{left}" y="{y}" width="{250 * ours / others:.1f}" height="13" fill="{OURS}"/>')
            parts.append(text(left + 250 * ours / others + 6, y + 11, ours, 12, OURS, "start"))
            parts.append(f'<rect x="{left}" y="{y + 15}" width="250" height="13" fill="{OTHERS}"/>')
            parts.append(text(left + 256, y + 26, others, 12, FAINT, "start"))
    parts.append(text(110, 244, "kane", 12.5, OURS, "start"))
    parts.append(text(160, 244, "CasADi 3.8.2, from Pinocchio's templates", 12.5, FAINT, "start"))
    write("operations.svg", 800, 258, parts)


def axes(x, y, turn=0, size=34, color=OURS):
    return (
        f'<g transform="translate({x} {y}) rotate({turn})" stroke="{color}" stroke-width="2" fill="{color}">'
        f'<line x1="0" y1="0" x2="{size}" y2="0" marker-end="url(#tip)"/><line x1="0" y1="0" x2="0" y2="{-size}" marker-end="url(#tip)"/>'
        f'<circle r="3"/></g>'
    )


def attachment():
    parts = []
    parts.append('<path d="M70 210 q-30 -70 40 -120 q90 -50 160 10 q50 60 -10 110 q-90 60 -190 0z" fill="#f3f4f6" stroke="#1f2933" stroke-width="1.4"/>')
    parts.append('<path d="M400 170 q-20 -70 60 -110 q110 -40 180 20 q40 60 -20 110 q-110 50 -220 -20z" fill="#f3f4f6" stroke="#1f2933" stroke-width="1.4"/>')
    parts += [text(170, 216, "lower body J", 13, FAINT), text(570, 180, "body K", 13, FAINT)]
    parts += [axes(120, 180), text(106, 198, "O_J", 13)]
    parts.append(line(120, 180, 254, 122))
    parts.append(text(196, 172, "q_K = attachment", 13, INK, "start"))
    parts += [f'<circle cx="257" cy="120" r="4" fill="{INK}"/>', text(256, 108, "joint", 12, FAINT)]
    parts.append(line(259, 121, 424, 148, OURS))
    parts.append(text(342, 112, "s_K", 13, OURS))
    parts += [axes(430, 149, -20), text(420, 172, "O_K", 13)]
    parts.append(line(430, 149, 545, 110))
    parts += [f'<circle cx="548" cy="109" r="5" fill="none" stroke="{INK}" stroke-width="1.6"/>', text(566, 104, "G_K", 13, INK, "start")]
    parts.append(text(500, 146, "r_K = mass_center", 13, INK, "start"))
    parts.append(text(370, 250, "The joint translates by s_K. q_K and s_K have components along J's axes, r_K along K's axes.", 13, INK))
    write("attachment.svg", 740, 266, parts)


def turned(x, y, angle, names, size=78, color=OURS, plain=True):
    """Axes in a plane, the first to the right and the second up; the third leads out of the page."""
    from math import cos, radians, sin

    parts = []
    if plain:
        parts += [line(x, y, x + size, y, FAINT, width=1.4), line(x, y, x, y - size, FAINT, width=1.4)]
        parts += [text(x + size + 10, y + 5, names[0], 13, FAINT, "start"), text(x, y - size - 8, names[1], 13, FAINT)]
    c, s = cos(radians(angle)), sin(radians(angle))
    parts += [line(x, y, x + size * c, y - size * s, color), line(x, y, x - size * s, y - size * c, color)]
    parts += [text(x + (size + 14) * c, y - (size + 14) * s + 4, names[2], 13, color), text(x - (size + 14) * s, y - (size + 14) * c + 4, names[3], 13, color)]
    parts += [f'<circle cx="{x}" cy="{y}" r="7" fill="{PAPER}" stroke="{INK}" stroke-width="1.4"/>', f'<circle cx="{x}" cy="{y}" r="2.2" fill="{INK}"/>']
    parts.append(f'<path d="M{x + 46} {y} A46 46 0 0 0 {x + 46 * c:.1f} {y - 46 * s:.1f}" fill="none" stroke="{INK}" stroke-width="1.2" marker-end="url(#tip)"/>')
    return parts


def rotation():
    parts = []
    steps = [
        ("1. theta_1 about x", ["y", "z", "y'", "z'"], "x", "theta_1"),
        ("2. theta_2 about the new y", ["z'", "x'", "z''", "x''"], "y'", "theta_2"),
        ("3. theta_3 about the last z", ["x''", "y''", "x_K", "y_K"], "z''", "theta_3"),
    ]
    for i, (title, names, axis, angle) in enumerate(steps):
        x = 80 + 250 * i
        parts.append(text(x - 40, 24, title, 13.5, INK, "start", 'font-weight="bold"'))
        parts += turned(x, 150, 28, names)
        parts.append(text(x - 16, 166, axis, 13, INK, "end"))
        parts.append(text(x + 54, 134, angle, 12, INK, "start"))
    parts.append(text(375, 200, "In each figure the axis of rotation leads out of the page; a positive angle turns counterclockwise.", 12.5, FAINT))
    write("rotation.svg", 750, 216, parts)


def matrix():
    parts = turned(90, 170, 30, ["x_J", "y_J", "x_K", "y_K"], 110)
    parts.append(text(152, 160, "theta_3", 12, INK, "start"))
    parts += [line(90, 170, 170, 74, INK, width=2.2), text(178, 68, "v", 15, INK, "start", 'font-style="italic"')]
    for i, words in enumerate([
        "v is one vector. It has components in both axes:",
        "v_K = R v_J, with R = rotation matrix from J to K",
        "R = [ cos  sin  0 ;  -sin  cos  0 ;  0  0  1 ]",
        "Row i of R is axis i of K, in components of J.",
        "The transposed matrix leads back: v_J = R^T v_K.",
    ]):
        parts.append(text(300, 66 + 28 * i, words, 14, OURS if i == 1 else INK, "start"))
    write("matrix.svg", 660, 200, parts)


for draw in (pipeline, operations, attachment, rotation, matrix):
    draw()
