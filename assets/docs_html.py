#!/usr/bin/env python3
"""The documentation that lies beside the page, as HTML that needs no script.

  docs_html.py FOLDER TARGET NAME...

FOLDER/NAME.md, for each NAME, becomes TARGET/docs-NAME.html. Links between them lead from one to the other; what is not
beside the page loses its link and keeps its words. It knows the part of Markdown that our documentation uses: headings,
paragraphs, lists, tables, quotations, fenced code, pictures, links, `code`, **strong** and *emphasis*. HTML is text like
any other.
"""
import html
import re
import sys
from pathlib import Path

# What a line begins with that is not a line of a paragraph.
ITEM = re.compile(r"( *)([-*]|\d+\.) +(.*)")
HEADING = re.compile(r"(#{1,6}) +(.*)")
INLINE = re.compile(
    r"\\(?P<escaped>[\\`*_|\[\]<>])"
    r"|(?P<ticks>`+)(?P<code>.+?)(?P=ticks)"
    r"|!\[(?P<alternative>[^\]]*)\]\((?P<picture>[^)\s]+)\)"
    r"|\[(?P<words>(?:`[^`]*`|[^\]`])*)\]\((?P<address>[^)\s]+)\)"
    r"|\*\*(?P<strong>(?:`[^`]*`|[^*`]|\*(?!\*))+)\*\*"
    r"|(?<![\w*])\*(?P<emphasis>(?:`[^`]*`|[^*`\s])(?:`[^`]*`|[^*`])*?)\*(?![\w*])")


def text_as_html(text):
    """Text as HTML. "82 %" stays on one line."""
    return html.escape(re.sub(r"(?<=\d) (?=%)", "\u00a0", text), quote=False)


def code(text):
    """Code within a line. The name of an option stays on one line, which might break behind its hyphens."""
    kind = ' class="option"' if re.fullmatch(r"-\S+", text) else ""
    return f"<code{kind}>{html.escape(text, quote=False)}</code>"


class Page:
    """One file: its lines become HTML from the first to the last."""

    def __init__(self, text, others):
        self.lines = text.replace("\r", "").split("\n")
        self.others = others
        self.at = 0
        self.anchors = set()
        self.title = ""

    def here(self):
        return self.lines[self.at] if self.at < len(self.lines) else None

    def anchor(self, words):
        """The name by which links lead to a heading: as on the usual hosts of repositories."""
        plain = re.sub(r"[^\w\- ]", "", re.sub(r"<[^>]*>", "", words).strip().lower()).replace(" ", "-")
        name, count = plain, 0
        while name in self.anchors:
            count += 1
            name = f"{plain}-{count}"
        self.anchors.add(name)
        return name

    def link(self, words, address):
        inside = self.inline(words)
        file, _, part = address.partition("#")
        if file == "" or re.match(r"[a-z]+:", address):
            return f'<a href="{html.escape(address)}">{inside}</a>'
        name = file.removesuffix(".md")
        if name not in self.others:
            return inside
        return f'<a href="docs-{name}.html{html.escape("#" + part) if part else ""}">{inside}</a>'

    def inline(self, text):
        out, end = [], 0
        for match in INLINE.finditer(text):
            out.append(text_as_html(text[end:match.start()]))
            end = match.end()
            kind, found = match.lastgroup, match.groupdict()
            if kind == "escaped":
                out.append(html.escape(found["escaped"]))
            elif found["code"] is not None:
                out.append(code(found["code"].strip()))
            elif kind == "picture":
                name = Path(found["picture"]).name
                out.append(f'<img src="docs-{name}" alt="{html.escape(found["alternative"])}">')
            elif kind == "address":
                out.append(self.link(found["words"], found["address"]))
            else:
                tag = "strong" if kind == "strong" else "em"
                out.append(f"<{tag}>{self.inline(found[kind])}</{tag}>")
        out.append(text_as_html(text[end:]))
        return "".join(out)

    def fenced(self, indent):
        self.at += 1
        code = []
        while self.here() is not None and not self.here().strip().startswith("```"):
            line = self.here()
            code.append(line[min(indent, len(line) - len(line.lstrip())):])
            self.at += 1
        self.at += 1
        return f'<pre tabindex="0"><code>{html.escape(chr(10).join(code), quote=False)}</code></pre>'

    def table(self):
        rows = []
        while self.here() is not None and self.here().startswith("|"):
            cells = re.split(r"(?<!\\)\|", self.here().strip().strip("|"))
            rows.append([self.inline(cell.strip()) for cell in cells])
            self.at += 1
        head, body = rows[0], rows[2:]  # between them stands the line of dashes
        inside = "".join(self.row(cells, "td") for cells in body)
        return f'<div class="wide" tabindex="0"><table><thead>{self.row(head, "th")}</thead><tbody>{inside}</tbody></table></div>'

    @staticmethod
    def row(cells, tag):
        """An empty heading heads nothing."""
        return "<tr>" + "".join(f"<{tag}>{cell}</{tag}>" if cell else "<td></td>" for cell in cells) + "</tr>"

    def items(self, indent):
        """A list whose items begin at this indent; what is indented further belongs to the item before."""
        tag = "ol" if ITEM.match(self.here()).group(2)[0].isdigit() else "ul"
        items = []
        while self.here() is not None and (match := ITEM.match(self.here())) and len(match.group(1)) == indent:
            self.lines[self.at] = " " * match.start(3) + match.group(3)
            items.append(f"<li>{self.blocks(indent + 1)}</li>")
        return f"<{tag}>{''.join(items)}</{tag}>"

    def paragraph(self, indent):
        words = []
        while self.here() is not None and self.here().strip():
            line = self.here()
            if words and (ITEM.match(line) or HEADING.match(line) or line.lstrip().startswith(("```", ">", "|"))):
                break
            if words and len(line) - len(line.lstrip()) < indent:
                break
            words.append(line.strip())
            self.at += 1
        return f"<p>{self.inline(' '.join(words))}</p>"

    def quotation(self):
        inside = []
        while self.here() is not None and self.here().startswith(">"):
            inside.append(self.here()[1:].strip())
            self.at += 1
        return f"<blockquote><p>{self.inline(' '.join(inside))}</p></blockquote>"

    def heading(self, match):
        self.at += 1
        level, words = len(match.group(1)), self.inline(match.group(2))
        self.title = self.title or re.sub(r"<[^>]*>", "", words)
        return f'<h{level} id="{self.anchor(words)}">{words}</h{level}>'

    def blocks(self, indent=0):
        out = []
        while (line := self.here()) is not None:
            if not line.strip():
                self.at += 1
            elif len(line) - len(line.lstrip()) < indent:
                break
            elif line.lstrip().startswith("```"):
                out.append(self.fenced(len(line) - len(line.lstrip())))
            elif match := HEADING.match(line):
                out.append(self.heading(match))
            elif match := ITEM.match(line):
                out.append(self.items(len(match.group(1))))
            elif line.startswith("|"):
                out.append(self.table())
            elif line.startswith(">"):
                out.append(self.quotation())
            else:
                out.append(self.paragraph(indent))
        return "\n".join(out)


def whole(title, ways, body):
    return f"""<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title} – evenlift</title>
<link rel="icon" href="icon.svg">
<link rel="stylesheet" href="docs.css">
<nav aria-label="Documentation">{ways}</nav>
<main>
{body}
</main>
</html>
"""


def main(folder, target, names):
    pages = {name: Page((folder / f"{name}.md").read_text(encoding="utf-8"), names) for name in names}
    bodies = {name: page.blocks() for name, page in pages.items()}
    for name, page in pages.items():
        ways = " ".join(f'<a href="docs-{other}.html"{" aria-current=page" if other == name else ""}>{pages[other].title}</a>'
                        for other in names)
        (target / f"docs-{name}.html").write_text(whole(page.title, ways, bodies[name]), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3:])
