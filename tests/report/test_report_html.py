"""The HTML page: one file, nothing loaded, sorted and filtered by its own script in a real browser."""

import re
from dataclasses import replace
from html.parser import HTMLParser

import pytest
import report_samples as samples
from browser import dom, needs_chromium, screenshot
from support import four_point

from subdiv_cli.model import Drawing, Stencil
from subdiv_cli.quantities.curve import drawing
from subdiv_cli.report.html import render
from subdiv_cli.report.look import Look

DRAWN = replace(samples.FOUR_POINT, drawing=drawing(four_point("1/16"), converges=True))
NASTY = '<script>alert(1)</script>"><img src=x onerror=alert(2)>&\x1b\udcff'
PAGE = render([DRAWN, *samples.ALL[1:], replace(samples.UNDECIDED, name=NASTY, file=NASTY, hints=(NASTY,))], Look())
VOID = {"meta", "input", "br", "line", "polyline"}


class Balanced(HTMLParser):
    """Collects tags, and fails where one is closed that is not open."""

    def __init__(self):
        super().__init__()
        self.open, self.tags, self.attributes = [], [], []

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += attrs
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += attrs

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


def parsed(page):
    parser = Balanced()
    parser.feed(page)
    parser.close()
    assert parser.open == []
    return parser


def test_the_page_is_well_formed_and_self_contained():
    page = parsed(PAGE)
    assert page.tags.count("article") == 5
    assert page.tags.count("script") == 1
    assert page.tags.count("style") == 1
    assert not {"img", "link", "iframe"} & set(page.tags)
    assert not {"src", "onerror"} & {key for key, _ in page.attributes}
    assert all(value.startswith("#") for key, value in page.attributes if key == "href")
    assert "http:" not in PAGE
    assert "https:" not in PAGE
    PAGE.encode("utf-8")


def test_names_are_text_and_nothing_else():
    assert "<script>alert" not in PAGE
    assert "<img" not in PAGE
    assert "\x1b" not in PAGE
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in PAGE


def test_a_card_has_the_exact_numbers_stencils_and_the_curve():
    card = PAGE[PAGE.index('id="mask-1"') : PAGE.index('id="mask-2"')]
    assert "-1/16, 9/16, 9/16, -1/16" in card
    assert "f_(k-1) … f_(k+2)" in card
    points = re.search(r'<polyline class="phi" points="([^"]*)"', card)[1].split(" ")
    assert len(points) == len(DRAWN.drawing.curve) == 385
    assert "w = 1/16" in card
    assert "symmetric about 0" in card


def test_no_curve_without_convergence():
    page = render([replace(samples.DIVERGENT, drawing=drawing(four_point(1), converges=False))], Look())
    assert "<svg" not in page
    assert "φ is drawn where convergence is proved" in page


def test_a_curve_without_extent_can_be_drawn():
    flat = Drawing(rules=(Stencil(0, ()),), limit=Stencil(0, (1,)), curve=((0.0, 0.0),))
    assert "<polyline" in render([replace(samples.FOUR_POINT, drawing=flat)], Look())


SORT = """<script>
{
const links = () => Array.from(document.querySelectorAll(".overview tbody tr:not([hidden]) a"));
const names = () => links().map((a) => a.textContent);
const out = [];
const click = (i) => document.querySelectorAll(".overview th button")[i].click();
click(4); out.push(names().join("|"));
click(4); out.push(names().join("|"));
click(1); out.push(names().join("|"));
const text = document.getElementById("text");
text.value = "CHAIKIN"; text.dispatchEvent(new Event("input")); out.push(names().join("|"));
out.push(document.querySelectorAll(".card:not([hidden])").length);
const wide = document.documentElement.scrollWidth > window.innerWidth;
out.push(wide ? "too wide" : "fits");
document.title = out.join("\\n");
}
</script></body>"""


@needs_chromium
def test_the_browser_sorts_and_filters(tmp_path):
    page = tmp_path / "page.html"
    body = render([DRAWN, *samples.ALL[1:]], Look()).replace("</body>", SORT)
    page.write_text(body, encoding="utf-8")
    told = re.search(r"<title>(.*?)</title>", dom(tmp_path, page), re.DOTALL)[1].split("\n")
    four, half, six, broken = "four-point scheme", "halved Chaikin", "Deslauriers–Dubuc, 6 points", "masks/broken.toml"
    assert told[0] == "|".join((four, six, half, broken)), "by exponent, unknown ones last"
    assert told[1] == "|".join((six, four, half, broken)), "the other way round, unknown ones still last"
    assert told[2] == "|".join((six, four, half, broken)), "by name"
    assert told[3:] == [half, "1", "fits"]


@needs_chromium
@pytest.mark.parametrize("dark", [False, True])
def test_a_phone_shows_it_light_and_dark(tmp_path, dark):
    """The page is drawn in both schemes, and they differ in the ground they are drawn on."""
    page, picture = tmp_path / "page.html", tmp_path / "page.png"
    page.write_text(PAGE, encoding="utf-8")
    screenshot(tmp_path, page, picture, 390, 1600, dark)
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert picture.stat().st_size > 20_000
