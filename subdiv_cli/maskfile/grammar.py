"""The grammar of expressions and its recursive descent into trees. Each method's docstring has its grammar line.

    -w      1/2 + w      z^-3 (1+z)^2 (z^2/2 - w (z-1)^2 (1+z^2))
    log2(64/9)      -log2(root(x^2-x-1, 1.61, 1.62))/2      (expectations only)

Sums and products read left to right; `-z^2` is -(z^2). Juxtaposition multiplies, but directly after the operand of a
`/` it is refused, since 1/2 w has two readings. The trees have no binary chains, so their depth is that of the
parentheses, which is bounded.
"""

from __future__ import annotations

import re
from collections.abc import Collection

from subdiv_cli.maskfile import rules as faults
from subdiv_cli.maskfile.bounds import MAX_EXPONENT, MAX_NESTING
from subdiv_cli.maskfile.nodes import Factor, Logarithm, Name, Node, Number, Power, RootOf, Sum, product_of
from subdiv_cli.maskfile.problems import Fault, shown
from subdiv_cli.maskfile.tokens import Token, number, tokens

_DIGITS_BEFORE = re.compile(r"[0-9]{1,20}\Z")
_DIGITS = re.compile(r"[0-9]{1,20}")
ROOT_FORM = "root(x^2-x-1, 1.61, 1.62)"


def parse(text: str, names: Collection[str], *, logarithms: bool = False, at: int = 0) -> Node:
    """The tree of an expression over `names`. Raises Fault, its offset counted from `at` for the first character."""
    parser = Parser(text, names, logarithms=logarithms, at=at)
    node = parser.sum()
    parser.finish()
    return node


class Parser:
    """A pass over the tokens of one text; `token` is the next one."""

    def __init__(self, text: str, names: Collection[str], *, logarithms: bool = False, at: int = 0) -> None:
        self._tokens = tokens(text, at)
        self._text, self._at = text, at
        self._names = names
        self._logarithms = logarithms
        self._depth = 0
        self._inside_root = False
        self._variable: str | None = None
        self.token = next(self._tokens)
        if self.token.kind == "end":
            raise Fault(
                faults.BAD_EXPRESSION,
                "the expression is empty",
                'write a number or an expression, for instance "-1/16"',
                at,
            )

    def advance(self) -> Token:
        """The next token, which is consumed."""
        taken = self.token
        self.token = next(self._tokens)
        return taken

    def finish(self) -> None:
        """Refuse anything after a complete expression. Raises Fault."""
        if self.token.kind == "end":
            return
        if self.token.kind == ")":
            raise Fault(
                faults.BAD_EXPRESSION,
                'this ")" closes nothing',
                'remove it, or add the "(" it belongs to',
                self.token.at,
            )
        raise self.unexpected("an operator or the end")

    def unexpected(self, expected: str) -> Fault:
        """The fault of a token that cannot stand where it does."""
        token = self.token
        if token.kind == "end":
            return Fault(
                faults.BAD_EXPRESSION, f"the expression ends where {expected} was expected", "complete it", token.at
            )
        if token.kind == ",":
            here = token.at - self._at
            whole, decimals = _DIGITS_BEFORE.search(self._text, 0, here), _DIGITS.match(self._text, here + 1)
            own = f"{whole[0]}.{decimals[0]}" if whole and decimals else "0.5"
            help = f"write decimals with a point: {shown(own, 30)}"
        elif token.kind == "^":
            help = "a power needs a base before ^ and a single integer after it: (z^2)^3"
        elif token.kind in ("[", "]"):
            help = "an expression has no lists; use parentheses"
        else:
            help = f"remove it or write {expected} before it"
        message = f'"{shown(token.text)}" stands where {expected} was expected'
        return Fault(faults.BAD_EXPRESSION, message, help, token.at)

    def sum(self) -> Node:
        """The tree of a sum: product { ("+" | "-") product }."""
        at = self.token.at
        terms = [(1, self.product())]
        while self.token.kind in ("+", "-"):
            sign = 1 if self.advance().kind == "+" else -1
            terms.append((sign, self.product()))
        return terms[0][1] if len(terms) == 1 else Sum(tuple(terms), at)

    def product(self) -> Node:
        """The tree of a product: factor { "*" factor | "/" factor | power }. Raises Fault.

        The bare power does not stand directly after a divisor.
        """
        at = self.token.at
        factors = [Factor(self.factor(), False, at)]
        while True:
            where = self.token.at
            if self.token.kind in ("*", "/"):
                divides = self.advance().kind == "/"
                factors.append(Factor(self.factor(), divides, where if not divides else self._divisor_at))
            elif self.token.kind in ("name", "("):
                if factors[-1].divides:
                    raise self._two_readings(at, self._divisor_at)
                factors.append(Factor(self.power(), False, where))
            elif self.token.kind == "number":
                raise Fault(
                    faults.BAD_EXPRESSION,
                    f"the number {shown(self.token.text)} stands directly after {_in_words(factors[-1].node)}",
                    "write * or / or + between them, or ^ for a power",
                    where,
                )
            else:
                break
        return factors[0].node if len(factors) == 1 else product_of(factors, at)

    def _two_readings(self, start: int, divisor: int) -> Fault:
        """The fault of what stands directly after a division that began at `start`."""
        after = shown(self.token.text, 20) if self.token.kind == "name" else "(…)"
        before, divided = self._between(start, divisor).rstrip("/ "), self._between(divisor, self.token.at)
        return Fault(
            faults.BAD_EXPRESSION,
            f'"{shown(self.token.text)}" directly after a division has two readings',
            f"write * to multiply, {before}/{divided} * {after}, or put the divisor in parentheses, "
            f"{before}/({divided} {after})",
            self.token.at,
        )

    def _between(self, start: int, end: int) -> str:
        """The text between two offsets, for a help."""
        return shown(self._text[start - self._at : end - self._at].strip(), 30)

    def factor(self) -> Node:
        """The tree of a factor: { "-" | "+" } power."""
        at = self._divisor_at = self.token.at
        negative = False
        while self.token.kind in ("+", "-"):
            negative ^= self.advance().kind == "-"
        node = self.power()
        self._divisor_at = at
        if negative:
            return Number(-node.value, at) if isinstance(node, Number) else Sum(((-1, node),), at)
        return node

    def power(self) -> Node:
        """The tree of a power: atom [ "^" exponent ]. Raises Fault."""
        at = self.token.at
        base = self.atom()
        if self.token.kind != "^":
            return base
        self.advance()
        node = Power(base, self.exponent(), at)
        if self.token.kind == "^":
            help = f"use parentheses: ({self._between(at, self.token.at)})^…"
            raise Fault(faults.BAD_EXPRESSION, "a power of a power has two readings", help, self.token.at)
        return node

    def exponent(self) -> int:
        """The integer of an exponent: [ "-" | "+" ] INTEGER | "(" exponent ")". Raises Fault."""
        closing = 0
        while self.token.kind == "(" and closing < MAX_NESTING:
            self.advance()
            closing += 1
        sign = 1
        if self.token.kind in ("+", "-"):
            sign = 1 if self.advance().kind == "+" else -1
        token = self.token
        if token.kind != "number" or not token.text.isdigit():
            what = "ends" if token.kind == "end" else f'continues with "{shown(token.text)}"'
            message = f"an integer was expected after ^, but the expression {what}"
            raise Fault(faults.BAD_EXPRESSION, message, "an exponent is an integer: z^2, z^-3", token.at)
        value = number(token)
        if value > MAX_EXPONENT:
            message = f"the exponent {shown(token.text)} is too large; the limit is {MAX_EXPONENT}"
            raise Fault(faults.OUT_OF_BOUNDS, message, "use a smaller power", token.at)
        self.advance()
        for _ in range(closing):
            if self.token.kind != ")":
                raise Fault(
                    faults.BAD_EXPRESSION,
                    "an exponent must be a single integer",
                    "write the integer: z^2, z^-3",
                    self.token.at,
                )
            self.advance()
        return sign * int(value)

    def atom(self) -> Node:
        """The tree of an atom: NUMBER | NAME | "(" sum ")" | "log" BASE "(" sum ")" | root."""
        token = self.token
        if token.kind == "number":
            self.advance()
            return Number(number(token), token.at)
        if token.kind == "(":
            return self._group()
        if token.kind != "name":
            raise self.unexpected("a number, a name or a parenthesis")
        self.advance()
        if self._logarithms and token.text.startswith("log") and token.text[3:].isdigit() and self.token.kind == "(":
            base = number(Token("number", token.text[3:], token.at + 3))
            return Logarithm(int(base), self._group(), token.at)
        if self._logarithms and token.text == "root" and self.token.kind == "(":
            return self._root(token.at)
        if self._inside_root and (len(token.text) == 1 or self.token.kind != "("):
            return self._unknown(token)
        if token.text not in self._names:
            from subdiv_cli.maskfile.stuck import unknown_name

            raise unknown_name(token, self._names, called=self.token.kind == "(", logarithms=self._logarithms)
        return Name(token.text, token.at)

    def _group(self) -> Node:
        opening = self._open()
        node = self.sum()
        self._close(opening)
        return node

    def _open(self) -> Token:
        opening = self.advance()
        self._depth += 1
        if self._depth > MAX_NESTING:
            message = f"parentheses are nested more than {MAX_NESTING} deep"
            raise Fault(faults.OUT_OF_BOUNDS, message, "multiply something out", opening.at)
        return opening

    def _close(self, opening: Token) -> None:
        if self.token.kind == "end":
            raise Fault(faults.BAD_EXPRESSION, 'this "(" is never closed', 'add the missing ")"', opening.at)
        if self.token.kind != ")":
            raise self.unexpected('an operator or ")"')
        self.advance()
        self._depth -= 1

    def _root(self, at: int) -> Node:
        """The tree of a root: "root" "(" sum "," sum "," sum ")", the first sum a polynomial in any one letter."""
        opening = self._open()
        self._logarithms, self._inside_root, self._variable = False, True, None
        polynomial = self.sum()
        self._inside_root = False
        bounds = []
        for _ in range(2):
            if self.token.kind != ",":
                raise Fault(
                    faults.BAD_EXPECTATION,
                    "a root has a polynomial and two bounds",
                    f"write {ROOT_FORM}",
                    self.token.at,
                )
            self.advance()
            bounds.append(self.sum())
        self._logarithms = True
        self._close(opening)
        return RootOf(polynomial, bounds[0], bounds[1], at)

    def _unknown(self, token: Token) -> Name:
        """The variable of a root's polynomial, whatever its letter is."""
        if len(token.text) > 1 or self._variable not in (None, token.text):
            message = f'"{shown(token.text)}" stands in a polynomial of one variable, a single letter'
            raise Fault(faults.BAD_EXPECTATION, message, f"write {ROOT_FORM}", token.at)
        self._variable = token.text
        return Name("z", token.at)


def _in_words(node: Node) -> str:
    if isinstance(node, Name):
        return f'"{shown(node.name)}"'
    return "another number" if isinstance(node, Number) else "a factor"
