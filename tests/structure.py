#!/usr/bin/env python3
"""Compares what the headers say about their structure with what they are.

Usage: structure.py [--report | --tap | --write] [--all] [HEADER...]     (default: paradt.h paradt_mpi.h)
  --report  prints each difference as one line, grouped by kind, and a count (the default)
  --tap     prints each kind as one TAP test with its differences
  --write   rewrites the line counts of the contents in place, and adds nothing else
  --all     also compares types, constants, tables and macros without arguments

A section begins with a rule, a line "// >>name" and its head comment, and ends where the next section or part begins. A
sentence of the head that begins with "Doors: " or "Door: " lists the functions that other sections may call, up to its full
stop. "paradt__mesh_*" stands for all names that begin so; "paradt__space_begin, _end" is short for paradt__space_begin and
paradt__space_end. Public functions are doors without being listed. A later header may use the doors of an earlier one.

The contents stand in the chapter READING THE IMPLEMENTATION, one line a section: "//     mesh     450   what it is for".
"""
import os
import re
import sys

MOST_LINES = 700
SECTION = re.compile(r'// >>(\S.*)$')
RULE = re.compile(r'// -{20,}$')
PART = re.compile(r'// ={20,}$')
CONTENTS = re.compile(r'//( {2,})(\S+(?: \S+)*)( {2,})(\d+)(  +\S.*)$')
NAME = re.compile(r'[A-Za-z_]\w*')
OURS = re.compile(r'(paradt|PARADT)_\w+$')


class Section:
    def __init__(self, header, name, first, order):
        self.header, self.name, self.first, self.order = header, name, first, order
        self.end = first    # the line after its last one; both count from 0
        self.doors = []     # (pattern, line)

    def __str__(self):
        return '%s >>%s' % (self.header, self.name) if self.name else '%s before its sections' % self.header

    def opens(self, name):
        return any(name == door or door.endswith('*') and name.startswith(door[:-1]) for door, _ in self.doors)


class Definition:
    def __init__(self, name, kind, section, line):
        self.name, self.kind, self.section, self.line = name, kind, section, line


def without_comments(text):
    """The text with comments and the insides of strings blanked, line breaks kept."""
    pattern = re.compile(r'//(?:\\\n|[^\n])*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)

    def blank(match):
        found = match.group(0)
        if found[0] in '"\'':
            return found[0] + found[0]
        return ' ' + '\n' * found.count('\n')

    return pattern.sub(blank, text)


def logical_lines(code):
    """(number of the first line, text) with continued lines joined."""
    number, lines = 0, code.split('\n')
    while number < len(lines):
        first, text = number, lines[number]
        while text.endswith('\\') and number + 1 < len(lines):
            number += 1
            text = text[:-1] + ' ' + lines[number]
        number += 1
        yield first, text


def doors_of(head):
    """head: (line, text without //). The doors that its sentences list."""
    text, lines = '', []
    for number, line in head:
        text += line.strip() + '\n'
        lines += [number] * (len(line.strip()) + 1)
    doors = []
    for sentence in re.finditer(r'(?:^|(?<=\s))Doors?: (.*?)\.(?=\s|$)', text, re.S):
        whole = None
        for door in re.finditer(r'(?<!\w)_[a-z]\w*|\b[A-Za-z_]\w*\*?', sentence.group(1)):
            name, line = door.group(0), lines[sentence.start(1) + door.start()]
            if name.startswith('_') and whole:
                name = whole[:whole.rindex('_')] + name
            if OURS.match(name.rstrip('*')) or name.endswith('*') and OURS.match(name[:-1] + 'x'):
                doors.append((name, line))
                whole = name if not name.startswith('_') else whole
    return doors


class Header:
    def __init__(self, path, order):
        self.path, self.name = path, os.path.basename(path)
        with open(path, encoding='utf-8') as file:
            self.text = file.read()
        self.lines = self.text.split('\n')
        self.find_sections(order)
        self.definitions, self.uses = [], []    # a use: (name, section, line, is a prefix of a pasted name)
        self.read_code()

    def find_sections(self, order):
        self.before = Section(self.name, '', 0, order)
        self.sections = []
        for i, line in enumerate(self.lines):
            found = SECTION.match(line)
            if found and i and RULE.match(self.lines[i - 1]):
                section = Section(self.name, found.group(1), i - 1, order + len(self.sections) + 1)
                head = []
                for j in range(i + 1, len(self.lines)):
                    if not self.lines[j].startswith('//') or RULE.match(self.lines[j]):
                        break
                    head.append((j, self.lines[j][2:]))
                section.doors = doors_of(head)
                self.sections.append(section)
        for section, following in zip(self.sections, self.sections[1:] + [None]):
            end = following.first if following else len(self.lines)
            for i in range(section.first + 1, end):
                if PART.match(self.lines[i]) or not following and self.lines[i] == '#ifdef __cplusplus':
                    end = i
                    break
            section.end = end
        self.before.end = self.sections[0].first if self.sections else len(self.lines)

    def section_at(self, line):
        found = self.before
        for section in self.sections:
            if section.first > line:
                break
            found = section
        return found

    def define(self, name, kind, line):
        if OURS.match(name):
            self.definitions.append(Definition(name, kind, self.section_at(line), line))

    def use_names(self, text, line, skip=()):
        for found in NAME.finditer(text):
            name = found.group(0)
            if OURS.match(name) and found.start() not in skip:
                pasted = text[found.end():].lstrip().startswith('##')
                if not (pasted and name.endswith('_')): # what a macro defines in several copies
                    self.uses.append((name, self.section_at(line), line, pasted))

    def read_code(self):
        """Finds what is defined outside of braces, and every use of a name. A directive's text counts as used where it stands."""
        depth, branches = 0, []
        outside = ''        # text since the last ; or } outside of braces
        outside_lines = []  # its lines, a character each
        for number, line in logical_lines(without_comments(self.text)):
            directive = re.match(r'\s*#\s*(\w+)', line)
            if directive:
                word, rest = directive.group(1), line[directive.end():]
                if word in ('if', 'ifdef', 'ifndef'):
                    branches.append((depth, outside, outside_lines[:]))
                elif word in ('else', 'elif') and branches:
                    depth, outside, outside_lines = branches[-1][0], branches[-1][1], branches[-1][2][:]
                elif word == 'endif' and branches:
                    branches.pop()
                if word == 'define':
                    macro = re.match(r'\s*(\w+)(\(?)', rest)
                    self.define(macro.group(1), 'macro' if macro.group(2) else 'constant', number)
                    self.use_names(rest, number, (macro.start(1),))
                elif word in ('if', 'elif'):
                    self.use_names(rest, number)
                continue
            self.use_names(line, number)
            line = re.sub(r'extern\s*""\s*\{', '', line) # its end is where depth stays 0
            for character in line + '\n':
                if depth == 0:
                    outside += character
                    outside_lines.append(number)
                if character == '{':
                    depth += 1
                    if depth == 1 and self.read_declaration(outside, outside_lines, True):
                        outside, outside_lines = '', []
                elif character == '}':
                    if depth == 1 and not re.search(r'\b(struct|union|enum)\b[^;]*\{$|=\s*\{$', outside, re.S):
                        outside, outside_lines = '', []
                    depth = max(depth - 1, 0)
                    if depth == 0:
                        outside += character if outside else ''
                        outside_lines += [number] if outside else []
                elif character == ';' and depth == 0:
                    self.read_declaration(outside, outside_lines, False)
                    outside, outside_lines = '', []
        self.read_enumerators()

    def read_declaration(self, text, lines, opened):
        """The text before a brace that opens, or up to a semicolon, outside of all braces. True: a function's head."""
        plain = re.sub(r'__attribute__\s*\(\(.*?\)\)', lambda m: ' ' * len(m.group(0)), text, flags=re.S)
        if opened:
            head = re.search(r'(?<![\w.])([A-Za-z_]\w*)\s*\((?:[^()]|\([^()]*\))*\)\s*\{$', plain)
            if head and '=' not in plain[:head.start()]:
                self.define(head.group(1), 'function', lines[head.start(1)])
                return True
            kind = re.search(r'\b(?:struct|union|enum)\s+(\w+)\s*\{$', plain)
            if kind:
                self.define(kind.group(1), 'type', lines[kind.start(1)])
            table = re.search(r'\b(\w+)\s*(?:\[[^\]]*\]\s*)*=\s*\{$', plain)
            if table:
                self.define(table.group(1), 'table', lines[table.start(1)])
            return False
        alias = re.search(r'^\s*typedef\b.*?\(\s*\*\s*(\w+)\s*\)', plain, re.S) or \
            re.search(r'^\s*typedef\b.*?\b(\w+)\s*(?:\[[^\]]*\]\s*)*;$', plain, re.S)
        if alias:
            self.define(alias.group(1), 'type', lines[alias.start(1)])
        return False

    def read_enumerators(self):
        for body in re.finditer(r'\benum\b[^;{}()]*\{([^{}]*)\}', without_comments(self.text)):
            for name in re.finditer(r'(?:^|,)\s*(?:#[^\n]*\n\s*)*(\w+)', body.group(1)):
                line = self.text_line(body.start(1) + name.start(1))
                self.define(name.group(1), 'constant', line)

    def text_line(self, offset):
        if not hasattr(self, 'blanked'):
            self.blanked = without_comments(self.text)
        return self.blanked.count('\n', 0, offset)

    def contents(self):
        """(line, match) of each line of the contents; None: the header has no chapter that would have them."""
        starts = [i for i, line in enumerate(self.lines) if re.match(r'//.*\bREADING THE IMPLEMENTATION$', line)]
        if not starts:
            return None
        found = []
        for i in range(starts[-1], self.before.end):
            if not self.lines[i].startswith('//') and self.lines[i]:
                break
            line = CONTENTS.match(self.lines[i])
            if line:
                found.append((i, line))
        return found


def compare(headers, everything):
    """The differences: {kind: [line of text]}."""
    kinds = ('function', 'macro') + (('type', 'constant', 'table') if everything else ())
    defined = {}
    for header in headers:
        for definition in header.definitions:
            # A public function counts where its body is, and a type where it is complete.
            defined.setdefault(definition.name, []).append(definition)
    by_prefix = sorted(defined)
    used_from = {}      # name -> {section: first line}
    for header in headers:
        for name, section, line, pasted in header.uses:
            names = [n for n in by_prefix if n.startswith(name)] if pasted else [name]
            for one in names:
                if one in defined and section not in [d.section for d in defined[one]]:
                    used_from.setdefault(one, {}).setdefault(section, line)

    found = {'leaks': [], 'false doors': [], 'later': []}
    for name, sections in sorted(used_from.items(), key=lambda item: item[0]):
        first = min(defined[name], key=lambda d: d.section.order)
        home = first.section
        if not home.name or first.kind not in kinds:
            continue
        private = '__' in name
        leaks = []
        for section, line in sorted(sections.items(), key=lambda item: item[0].order):
            place = '%s:%d' % (section.header, line + 1)
            if not section.name:
                if private:
                    found['later'].append('%s: %s is used before the sections; %s defines it' % (place, name, home))
                continue
            if section.order < home.order:
                found['later'].append('%s: %s uses %s of the later %s' % (place, section, name, home))
            if private and not home.opens(name):
                leaks.append('>>%s %s' % (section.name, place))
        if leaks:
            found['leaks'].append('%s:%d: %s is no door of >>%s, and used in %s' %
                                  (home.header, first.line + 1, name, home.name, ', '.join(leaks)))
    found['leaks'].sort(key=lambda text: (text.split(':')[0], int(text.split(':')[1])))
    for header in headers:
        for section in header.sections:
            for door, line in section.doors:
                place = '%s:%d' % (header.name, line + 1)
                matching = [n for n in (by_prefix if door.endswith('*') else [door]) if n in defined and
                            n.startswith(door.rstrip('*')) and section in [d.section for d in defined[n]]]
                if not matching:
                    found['false doors'].append('%s: %s declares the door %s and does not define it' % (place, section, door))
                elif not any(n in used_from or '__' not in n for n in matching):
                    found['false doors'].append('%s: %s declares the door %s and nobody else uses it' % (place, section, door))
    return found


def compare_contents(headers):
    wrong, long = [], []
    for header in headers:
        contents = header.contents()
        if contents is None and header is headers[0]:
            wrong.append('%s: there is no chapter READING THE IMPLEMENTATION' % header.name)
        real = {section.name: section for section in header.sections}
        for i, line in contents or []:
            name, count = line.group(2), int(line.group(4))
            place = '%s:%d' % (header.name, i + 1)
            if name not in real:
                wrong.append('%s: the contents have %s, which is no section' % (place, name))
            elif count != real[name].end - real[name].first:
                wrong.append('%s: the contents give >>%s %d lines; it has %d' %
                             (place, name, count, real[name].end - real[name].first))
        if contents is not None:
            listed = [line.group(2) for _, line in contents]
            for section in header.sections:
                if listed.count(section.name) != 1:
                    wrong.append('%s: the contents list >>%s %d times' % (header.name, section.name, listed.count(section.name)))
            known = [name for name in listed if name in real]
            if known != sorted(known, key=lambda name: real[name].order):
                wrong.append('%s: the contents list the sections in another order' % header.name)
        for section in header.sections:
            if section.end - section.first > MOST_LINES:
                long.append('%s:%d: >>%s has %d lines; at most %d are wanted' %
                            (header.name, section.first + 1, section.name, section.end - section.first, MOST_LINES))
    return wrong, long


def write_counts(header):
    real = {section.name: section.end - section.first for section in header.sections}
    changed = 0
    for i, line in header.contents() or []:
        before, name, gap, count, after = line.groups()
        if name in real and int(count) != real[name]:
            width = len(gap) + len(count)
            new = '//' + before + name + '  '.ljust(width - len(str(real[name]))) + str(real[name]) + after
            header.lines[i] = new
            changed += 1
    if changed:
        with open(header.path, 'w', encoding='utf-8') as file:
            file.write('\n'.join(header.lines))
    print('%s: %d counts changed' % (header.name, changed))


def main(arguments):
    options = [a for a in arguments if a.startswith('--')]
    if set(options) - {'--report', '--tap', '--write', '--all'}:
        print(__doc__, file=sys.stderr)
        return 2
    paths = [a for a in arguments if not a.startswith('--')] or ['paradt.h', 'paradt_mpi.h']
    headers = []
    for path in paths:
        headers.append(Header(path, 1000 * len(headers)))
    if '--write' in options:
        for header in headers:
            write_counts(header)
        return 0
    found = compare(headers, '--all' in options)
    wrong, long = compare_contents(headers)
    tests = [('sections_call_each_other_by_their_doors_alone', found['leaks']),
             ('every_door_is_there_and_used', found['false doors']),
             ('no_section_uses_a_later_one', found['later']),
             ('the_contents_list_every_section_with_its_lines', wrong),
             ('no_section_is_longer_than_%d_lines' % MOST_LINES, long)]
    for number, (name, differences) in enumerate(tests, 1):
        if '--tap' in options:
            print('%sok %d - %s' % ('not ' if differences else '', number, name))
            for difference in differences:
                print('# ' + difference)
        else:
            print('%s: %d' % (name.replace('_', ' '), len(differences)))
            for difference in differences:
                print('    ' + difference)
    if '--tap' in options:
        print('1..%d' % len(tests))
    return 1 if any(differences for _, differences in tests) else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
