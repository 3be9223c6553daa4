"""The HTML page: one file, nothing loaded, sorted and filtered by its own script in a real browser."""

import re
from dataclasses import replace
from html.parser import HTMLParser

import numpy as np
import pytest
import report_samples as samples
from browser import dom, needs_chromium, phone, screenshot
from matplotlib.image import imread
from support import four_point

from subdiv_cli.kinds.scalar.portrait.sections import sections
from subdiv_cli.model.blocks import Curve, Formula, Grid, Section, Text
from subdiv_cli.report import renderer
from subdiv_cli.report.look import Look

render = renderer("html")

DRAWN = replace(samples.FOUR_POINT, sections=sections(four_point("1/16"), samples.FOUR_POINT))
HAT = Curve(2, 0, -1, (0, 1, 0), (-1, 1), 1)
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
    card = PAGE[PAGE.index('id="mask-1"') :]
    card = card[: card.index("</article>")]
    assert "-1/16, 9/16, 9/16, -1/16" in card
    assert "f_(k-1) … f_(k+2)" in card
    points = re.search(r'<polyline class="phi" points="([^"]*)"', card)[1].split(" ")
    assert len(points) == len(DRAWN.sections[0].blocks[0].values) == 385
    assert "w = 1/16" in card
    assert "symmetric about 0" in card


def test_no_curve_without_convergence():
    page = render([replace(samples.DIVERGENT, sections=sections(four_point(1), samples.DIVERGENT))], Look())
    assert "<svg" not in page
    assert "φ is drawn where convergence is proved" in page


def test_a_curve_without_extent_can_be_drawn():
    flat = Section("", (Curve(2, 0, 0, (0,), (0, 0)), Grid("", (), (("nothing", ()),))))
    page = render([replace(samples.FOUR_POINT, sections=(flat,))], Look())
    assert "<polyline" in page
    assert "<tr><th>nothing</th><td>0</td></tr>" in page


def test_words_and_formulas_are_set_and_escaped():
    said = (Section("a <b>", (Text("x < y"),)), Section("", (Text("so"), Formula("f", "g & h"), HAT)))
    page = render([replace(samples.FOUR_POINT, sections=said)], Look())
    assert '<h3>a &lt;b&gt;</h3><p class="text">x &lt; y</p>' in page
    assert "<pre>  so\n  f = g &amp; h\n</pre><figure><svg" in page
    assert "<figcaption>φ', exact values" in page


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


LOOK = """<script>
{
const channels = (colour) => colour.match(/[\\d.]+/g).map(Number);
const linear = (c) => (c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
const ground = (e) => {
  for (; e; e = e.parentElement) {
    const c = channels(getComputedStyle(e).backgroundColor);
    if (c.length < 4 || c[3] === 1) return c;
  }
  return [255, 255, 255];
};
let worst = 21, where = "";
for (const e of document.body.querySelectorAll("*:not(script):not(style)")) {
  const own = Array.from(e.childNodes).some((n) => n.nodeType === 3 && n.textContent.trim());
  if (!own || !e.getClientRects().length) continue;
  const [a, b] = [channels(getComputedStyle(e).color), ground(e)].map(luminance).sort((x, y) => y - x);
  const contrast = (a + 0.05) / (b + 0.05);
  if (contrast < worst) { worst = contrast; where = e.tagName + "." + e.className; }
}
const root = document.documentElement;
parent.postMessage([window.innerWidth, root.scrollWidth, worst.toFixed(2), where].join("|"), "*");
}
</script></body>"""


@needs_chromium
@pytest.mark.parametrize("dark", [False, True])
def test_a_phone_shows_it_readably_light_and_dark(tmp_path, dark):
    """Nothing is wider than 400 pixels, and every text stands out from its ground as WCAG 2 asks (4.5 to 1)."""
    page = tmp_path / "page.html"
    page.write_text(PAGE.replace("</body>", LOOK), encoding="utf-8")
    told = re.search(r"<title>(.*?)</title>", dom(tmp_path, phone(page), dark), re.DOTALL)[1].split("|")
    assert told[0] == "400"
    assert int(told[1]) <= 400
    assert float(told[2]) >= 4.5, told[3]


@needs_chromium
def test_light_and_dark_differ(tmp_path):
    """Most pixels are ground: white paper in the light, nearly black in the dark; and something is drawn on it."""
    page = tmp_path / "page.html"
    page.write_text(PAGE, encoding="utf-8")
    for dark in (False, True):
        picture = tmp_path / f"{dark}.png"
        screenshot(tmp_path, phone(page), picture, 400, 1600, dark)
        grey = imread(picture)[:, :, :3].mean(axis=2)
        assert grey.shape == (1600, 400)
        assert (np.median(grey) < 0.2) == dark
        assert (np.median(grey) > 0.9) != dark
        assert grey.max() - grey.min() > 0.6
        assert 0.01 < (abs(grey - np.median(grey)) > 0.3).mean() < 0.5
