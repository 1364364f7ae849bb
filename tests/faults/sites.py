# SPDX-License-Identifier: MIT
"""Where a C or C++ file can be made wrong, and how: one small fault a site, found from its tokens alone.

The sources are formatted by clang-format, and that is used: a binary operator has white space on both sides, a unary
one none behind it, the brackets of a template none at all.
"""
import collections
import re

# (number: among the sites of an operator that begin at the same place)
Site = collections.namedtuple("Site", "file line column operator number start end replacement")
Token = collections.namedtuple("Token", "kind text start end")

OPERATORS = {
    "sign": "+ and -, += and -=, ++ and --",
    "unary": "a unary minus is dropped",
    "bound": "< and <=, > and >=, == and !=",
    "swap": "a - b becomes b - a, a / b becomes b / a, two neighbouring arguments change places",
    "constant": "k becomes k + 1, a floating-point number its double (0.0 becomes 1.0)",
    "logic": "&& and ||; a ! is dropped; true and false",
    "call": "a call that is a statement is dropped",
    "assignment": "an assignment, a step (++, --) or a `continue` or `break` is dropped",
    "else": "an else branch is dropped",
    "extreme": "minimum and maximum",
}

TOKEN = re.compile(r"""
    (?P<comment>//(?:\\\n|[^\n])*|/\*.*?\*/)
  | (?P<raw>R"(?P<fence>[^(\s]*)\(.*?\)(?P=fence)")
  | (?P<string>(?:u8|[uUL])?"(?:\\.|[^"\\\n])*")
  | (?P<char>[uUL]?'(?:\\.|[^'\\\n])+')
  | (?P<directive>^[ \t]*\#(?:\\\n|/\*.*?\*/|//[^\n]*|[^\n])*)
  | (?P<number>(?:\d|\.\d)(?:[eEpP][+-]|'\w|[\w.])*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<punctuator>\.\.\.|<<=|>>=|->\*|::|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|[^\s\w])
""", re.VERBOSE | re.DOTALL | re.MULTILINE)

# Calls that hold or print text, check what cannot happen, or hold no value that is computed.
SILENT = {"assert", "static_assert", "_Static_assert", "b2Assert", "fprintf", "printf", "snprintf", "fputs", "fputc",
          "sizeof", "alignof", "offsetof", "defined", "decltype", "alignas", "__attribute__"}
KEYWORDS = {"if", "while", "for", "switch", "return", "case", "else", "do", "goto", "new", "delete", "throw", "catch",
            "sizeof", "co_return", "and", "or", "not"}
TYPE_WORDS = {"double", "float", "int", "unsigned", "signed", "long", "short", "char", "bool", "void", "const"}
OPENING, CLOSING = {"(": ")", "[": "]", "{": "}"}, {")": "(", "]": "[", "}": "{"}
BOUNDS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
SIGNS = {"+": "-", "-": "+", "+=": "-=", "-=": "+="}
STEPS = {"++": "--", "--": "++"}
ASSIGNING = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="}
EXTREMES = [("fmin", "fmax"), ("fminf", "fmaxf"), ("b2Min", "b2Max"), ("min", "max"), ("min4", "max4"), ("least_of4", "most_of4"),
            ("_mm_min_pd", "_mm_max_pd"), ("_mm_min_sd", "_mm_max_sd")]
EXTREME = {**dict(EXTREMES), **{b: a for a, b in EXTREMES}}

# Calls that mean the same with their arguments in the other order.
COMMUTING = re.compile(r"f?(min|max)f?|b2(Min|Max)|(\w*_)?dot|b2Dot|_mm_(add|mul|and|or|xor|cmpeq)_\w+|(add|mul|equal|unordered|both|either)4")


def tokens_of(text):
    found = []
    for match in TOKEN.finditer(text):
        kind = match.lastgroup if match.lastgroup != "fence" else "raw"
        if kind not in ("comment", "directive"):
            found.append(Token(kind, match.group(), match.start(), match.end()))
    return found


class File:
    """The tokens of one file, which of them open and close each other, and which lie inside a function."""

    def __init__(self, name, text):
        self.name, self.text = name, text
        self.tokens = tokens_of(text)
        self.pair = {}
        self.in_code = [False] * len(self.tokens)  # inside the body of a function
        self.in_value = [False] * len(self.tokens)  # that, or inside what a constant is initialised with
        self.begins = set()  # tokens that a statement begins with
        self.sites = []
        self._match()
        self._find_code()
        self._find_sites()

    def word(self, i):
        return self.tokens[i].text if 0 <= i < len(self.tokens) else ""

    def kind(self, i):
        return self.tokens[i].kind if 0 <= i < len(self.tokens) else ""

    def _match(self):
        stack = []
        for i, token in enumerate(self.tokens):
            if token.kind != "punctuator":
                continue
            if token.text in OPENING:
                stack.append(i)
            elif token.text in CLOSING and stack and self.word(stack[-1]) == CLOSING[token.text]:
                self.pair[i] = stack.pop()
                self.pair[self.pair[i]] = i

    def _opens(self, i, inside):
        """What the brace at token i opens, inside a room of this kind: scope, type, code or value."""
        before = self.word(i - 1)
        if inside == "value":
            return "value"
        if inside == "code":
            if before in (")", ";", "{", "}", ":") or before in ("else", "do", "try", "const", "mutable", "noexcept"):
                return "code"
            return "value"
        head = i
        while head > 0 and self.word(head - 1) not in ("{", "}", ";"):
            head -= 1
            if self.word(head) in (")", "]") and head in self.pair:
                head = self.pair[head]
        words = [self.word(k) for k in range(head, i)]
        if "namespace" in words or (words[:1] == ["extern"] and self.kind(i - 1) == "string"):
            return "scope"
        if "enum" in words:
            return "enum"
        if "(" in words and "=" not in words:
            return "code"
        if "=" in words:
            return "code" if before == ")" else "value"
        return "type" if {"struct", "class", "union"} & set(words) else "value"

    def _find_code(self):
        rooms, statement = [], False
        assigned = False  # behind an `=` outside functions
        for i, token in enumerate(self.tokens):
            inside = rooms[-1] if rooms else "scope"
            if token.text == "}" and token.kind == "punctuator" and rooms:
                rooms.pop()
                statement = True
                assigned = False
                continue
            if inside == "code" and statement:
                self.begins.add(i)
            statement = False
            self.in_code[i] = "code" in rooms and inside != "enum"
            self.in_value[i] = self.in_code[i] or ((assigned or inside == "value") and inside != "enum")
            if token.kind == "name" and token.text in ("else", "do"):
                statement = True
            if token.kind != "punctuator":
                continue
            if token.text == "{":
                rooms.append(self._opens(i, inside))
                statement = rooms[-1] == "code"
            elif token.text == ";":
                # The semicolons of a for are inside its parentheses.
                statement, assigned = not self._in_parentheses(i), False
            elif token.text == "=" and inside != "code":
                assigned = True
            elif token.text == ")" and i in self.pair and self.word(self.pair[i] - 1) in ("if", "for", "while", "switch"):
                statement = True
            elif token.text == ":" and inside == "code" and self._ends_label(i):
                statement = True

    def _in_parentheses(self, i):
        while i > 0 and self.word(i - 1) not in ("{", "}"):
            i -= 1
            if self.word(i) == ")" and i in self.pair:
                i = self.pair[i]
            elif self.word(i) == "(":
                return True
        return False

    def _ends_label(self, i):
        while i > 0 and self.word(i - 1) not in ("{", "}", ";"):
            i -= 1
        return self.word(i) in ("case", "default")

    # -- parts of expressions

    def _spaced(self, i):
        """White space on both sides: a binary operator."""
        token = self.tokens[i]
        return self.text[token.start - 1:token.start].isspace() and self.text[token.end:token.end + 1].isspace()

    def _left_operand(self, i):
        """First token of the term that ends at token i, or None."""
        while True:
            while self.word(i) in (")", "]") and i in self.pair:
                i = self.pair[i] - 1
                if self.word(i + 1) == "(" and self.kind(i) not in ("name",) and self.word(i) not in (")", "]", ">"):
                    i += 1
                    break
                if self.word(i) == ">":
                    while i > 0 and self.word(i) != "<":
                        i -= 1
                    i -= 1
            if not (self.kind(i) in ("name", "number") or self.word(i) == "(") or self.word(i) in KEYWORDS:
                return None
            if self.word(i - 1) in (".", "->", "::"):
                i -= 2
                continue
            while self.word(i - 1) in ("-", "!", "*", "&") and not self._spaced(i - 1):
                i -= 1
            if self.word(i - 1) in ("*", "/") and self._spaced(i - 1):
                i -= 2
                continue
            return i

    def _right_operand(self, i):
        """Last token of the term that begins at token i, or None."""
        while True:
            while self.word(i) in ("-", "!", "*", "&"):
                i += 1
            if self.word(i) == "(" and i in self.pair:
                i = self.pair[i]
            elif self.kind(i) not in ("name", "number") or self.word(i) in KEYWORDS:
                return None
            while True:
                following = self.word(i + 1)
                if following in ("(", "[") and i + 1 in self.pair:
                    i = self.pair[i + 1]
                elif following in (".", "->", "::"):
                    i += 2
                elif following == "<" and not self._spaced(i + 1):
                    while self.word(i) != ">" and i < len(self.tokens):
                        i += 1
                else:
                    break
            if self.word(i + 1) in ("*", "/") and self._spaced(i + 1):
                i += 2
                continue
            return i

    def _arguments(self, i):
        """(first, last) token of each argument between the parenthesis at token i and its other."""
        arguments, first, k = [], i + 1, i + 1
        while k < self.pair[i]:
            if self.word(k) in OPENING and k in self.pair:
                k = self.pair[k]
            elif self.word(k) == ",":
                arguments.append((first, k - 1))
                first = k + 1
            k += 1
        if first < self.pair[i]:
            arguments.append((first, self.pair[i] - 1))
        return arguments

    def _end_of_statement(self, i):
        """Last token of the statement that begins at token i."""
        if self.word(i) == "{":
            return self.pair.get(i)
        if self.word(i) in ("if", "for", "while"):
            body = i + 1 if self.word(i + 1) == "(" else i + 2
            if body not in self.pair:
                return None
            end = self._end_of_statement(self.pair[body] + 1)
            while end is not None and self.word(i) == "if" and self.word(end + 1) == "else":
                end = self._end_of_statement(end + 2)
            return end
        while i < len(self.tokens) and self.word(i) != ";":
            i = self.pair.get(i, i) + 1 if self.word(i) in OPENING else i + 1
        return i

    def _span(self, first, last):
        return self.text[self.tokens[first].start:self.tokens[last].end]

    # -- sites

    def _site(self, operator, first, last, replacement):
        start, end = self.tokens[first].start, self.tokens[last].end
        # Lines stay where they are.
        replacement += "\n" * (self.text.count("\n", start, end) - replacement.count("\n"))
        if replacement == self.text[start:end]:
            return
        line = self.text.count("\n", 0, start) + 1
        column = start - self.text.rfind("\n", 0, start)
        number = sum((s.line, s.column, s.operator) == (line, column, operator) for s in self.sites[-8:])
        self.sites.append(Site(self.name, line, column, operator, number, start, end, replacement))

    def _find_sites(self):
        silent_until = -1
        for i, token in enumerate(self.tokens):
            if token.text in SILENT and self.word(i + 1) == "(" and i + 1 in self.pair:
                silent_until = max(silent_until, self.pair[i + 1])
            if i <= silent_until:
                continue
            if self.in_value[i]:
                self._expression_sites(i, token)
            if self.in_code[i] and i in self.begins:
                self._statement_sites(i)
            if token.text == "else" and self.in_code[i] and self._end_of_statement(i + 1):
                self._site("else", i, self._end_of_statement(i + 1), "")

    def _expression_sites(self, i, token):
        text = token.text
        if token.kind == "number":
            self._site("constant", i, i, one_more(text))
        elif token.kind == "name":
            if text in EXTREME and self.word(i + 1) == "(":
                self._site("extreme", i, i, EXTREME[text])
            elif text in ("true", "false"):
                self._site("logic", i, i, "false" if text == "true" else "true")
            if self.word(i + 1) == "(" and i + 1 in self.pair and self.in_code[i] and \
                    text not in KEYWORDS and not COMMUTING.fullmatch(text):
                arguments = self._arguments(i + 1)
                for (a, b), (c, d) in zip(arguments, arguments[1:]):
                    gap = self.text[self.tokens[b].end:self.tokens[c].start]
                    self._site("swap", a, d, self._span(c, d) + gap + self._span(a, b))
        elif token.kind == "punctuator":
            if text in STEPS and i not in self.begins:
                self._site("sign", i, i, STEPS[text])
            elif text in ("!", "-") and not self._spaced(i) and self.kind(i + 1) != "" \
                    and not self.text[token.end].isspace():
                self._site("unary" if text == "-" else "logic", i, i, "")
            elif self._spaced(i):
                self._binary_sites(i, text)

    def _binary_sites(self, i, text):
        if text in SIGNS:
            self._site("sign", i, i, SIGNS[text])
        elif text in BOUNDS:
            self._site("bound", i, i, BOUNDS[text])
        elif text in ("&&", "||"):
            self._site("logic", i, i, "||" if text == "&&" else "&&")
        if text in ("-", "/"):
            left = self._left_operand(i - 1)
            right = self._right_operand(i + 1)
            if text == "/" and left is not None and right is not None:
                left, right = self._factor_left(i - 1, left), self._factor_right(i + 1, right)
            if left is not None and right is not None:
                between = self.text[self.tokens[i - 1].end:self.tokens[i + 1].start]
                self._site("swap", left, right, self._span(i + 1, right) + between + self._span(left, i - 1))

    def _factor_left(self, last, first):
        """The last factor of the term from first to last."""
        depth_free = [k for k in range(first, last) if self.word(k) in ("*", "/") and self._spaced(k)
                      and not self._enclosed(k, first, last)]
        return depth_free[-1] + 1 if depth_free else first

    def _factor_right(self, first, last):
        depth_free = [k for k in range(first, last) if self.word(k) in ("*", "/") and self._spaced(k)
                      and not self._enclosed(k, first, last)]
        return depth_free[0] - 1 if depth_free else last

    def _enclosed(self, k, first, last):
        return any(first <= a < k < b <= last for a, b in self.pair.items() if a < b)

    def _statement_sites(self, i):
        if self.word(i) in ("continue", "break") and self.word(i + 1) == ";":
            self._site("assignment", i, i, "")
            return
        end = i
        words = []
        while end < len(self.tokens) and self.word(end) not in (";", "{", "}"):
            words.append(end)
            end = self.pair[end] + 1 if self.word(end) in ("(", "[") and end in self.pair else end + 1
            if self.word(end) == "{" and self.word(end - 1) in ("=", ",") and end in self.pair:
                end = self.pair[end] + 1  # a compound value
        if self.word(end) != ";" or not words or self.word(i) in KEYWORDS or self._declares(words):
            return
        if any(self.word(k) in ASSIGNING or self.word(k) in STEPS for k in words):
            self._site("assignment", i, end - 1, "")
        elif self.word(words[-1]) == "(" and self.kind(i) == "name":
            self._site("call", i, end - 1, "")

    def _declares(self, words):
        """A declaration: two names follow each other before anything is assigned or called."""
        for a, b in zip(words, words[1:]):
            if self.word(b) in ASSIGNING:
                return False
            if self.kind(b) == "name" and (self.kind(a) == "name" or self.word(a) == ">"):
                return True
            if self.word(a) in ("*", "&", "&&") and self.kind(b) == "name" and a != words[0]:
                return True
        return self.word(words[0]) in TYPE_WORDS | {"using", "typedef", "static", "constexpr", "auto", "extern"}


def one_more(number):
    """k + 1 for an integer, the double for a floating-point number."""
    match = re.fullmatch(r"(0[xX][0-9a-fA-F']+|[\d']+)([uUlLzZ]*)", number)
    if match:
        value = int(match.group(1).replace("'", ""), 16 if match.group(1)[:2].lower() == "0x" else 10)
        return f"{value + 1}{match.group(2)}"
    match = re.fullmatch(r"([\d.']+(?:[eE][+-]?\d+)?)([fFlL]?)", number)
    if not match:
        return f"(2 * {number})"  # hexadecimal
    value = float(match.group(1).replace("'", ""))
    return f"{2.0 * value if value != 0.0 else 1.0!r}{match.group(2)}"


def lines_of_code(text):
    """The number of lines that hold a token."""
    return len({text.count("\n", 0, token.start) for token in tokens_of(text)})


def sites_of(name, text):
    return File(name, text).sites


def apply(site, text):
    return text[:site.start] + site.replacement + text[site.end:]


def name_of(site):
    """One word that says where a site is and which: file:line:column:operator, and a number where there are several."""
    return f"{site.file}:{site.line}:{site.column}:{site.operator}" + (f".{site.number}" if site.number else "")
