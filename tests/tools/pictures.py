#!/usr/bin/python3
"""pictures.py: the pictures of the elements in the manual, share/manual/pictures; a line `ok WHAT`
or `not ok WHAT` a check. Each word of the scene language (the nodes of elements.texi, which are
made of gsmbp_elements()) has one, or element_examples.texi says that it has none; each is shown;
each is a small drawing that needs nothing from outside, in the one style; info has its text.
"""
import glob
import os
import re
import xml.etree.ElementTree as tree

MANUAL = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../share/manual')
DRAWINGS = sorted(glob.glob(os.path.join(MANUAL, 'pictures/*')))
BYTES, COLUMNS = 6000, 100
ELSEWHERE = re.compile(r'\son\w+=|<\?|<!(?!--)|@import|javascript')


def text_of(path):
    with open(os.path.join(MANUAL, path), encoding='utf-8') as f:
        return f.read()


def name_of(path):
    return os.path.splitext(os.path.basename(path))[0]


def shown(examples):
    """word: [[picture, its text], ...]"""
    line = re.compile(r'(?m)^@image\{pictures/([^,{}]+),8cm,,([^,{}]+),\.svg\}$')
    return {word: line.findall(part)
            for word, part in re.findall(r'(?ms)^@c of (\w+)$(.*?)^@c end$', examples)}


def report(what, problems):
    print('not ok %s\n%s' % (what, '\n'.join(problems[:8])) if problems else 'ok ' + what)


def check_words(words, without, pictures):
    drawn = [name_of(path) for path in DRAWINGS]
    for word in sorted({*words, *without, *drawn, *pictures}):
        names = [name for name, _ in pictures.get(word, [])]
        if word not in words:
            yield '%s: no word of the scene language' % word
        elif word in without and (names or word in drawn):
            yield '%s: said to have no picture, but it has one' % word
        elif word not in without and (names != [word] or drawn.count(word) != 1):
            yield '%s: expected a picture of it, drawn and shown; shown: %s' % (word, names)


def check_drawing(path):
    text = text_of(path)
    try:
        root = tree.fromstring(text)
    except tree.ParseError as error:
        return [str(error)]
    found = []
    elements = list(root.iter())
    tags = {e.tag.split('}')[-1] for e in elements}
    names = {'#' + e.get('id') for e in elements if e.get('id')}
    links = {v for e in elements for k, v in e.attrib.items() if re.search(r'href$|^src$', k)}
    links |= set(re.findall(r'url\((.*?)\)', text))
    if not path.endswith('.svg') or root.get('viewBox') != '0 0 320 160':
        found.append('expected an SVG file with viewBox="0 0 320 160"')
    if len(text.encode()) > BYTES or max(map(len, text.split('\n'))) > COLUMNS:
        found.append('more than %d bytes, or a line over %d columns' % (BYTES, COLUMNS))
    if tags & {'script', 'image', 'foreignObject'} or ELSEWHERE.search(text):
        found.append('a script, a picture or a declaration in it')
    if links - names:
        found.append('references to what is not in it: %s' % sorted(links - names))
    if not root.findtext('{http://www.w3.org/2000/svg}title'):
        found.append('no title')
    return found


def main():
    examples = text_of('element_examples.texi')
    words = re.findall(r'(?m)^@node Element (\w+)$', text_of('elements.texi'))
    without = re.search(r'(?m)^@c without picture: (.*)$', examples).group(1).split()
    pictures = shown(examples)
    report('each of %d words of the scene language has its picture, or is one of %d without'
           % (len(words), len(without)),
           list(check_words(words, without, pictures)) if words else ['no words'])
    report('%d pictures are small drawings that need nothing from outside' % len(DRAWINGS),
           ['%s: %s' % (name_of(p), what) for p in DRAWINGS for what in check_drawing(p)])
    styles = {re.findall(r'(?s)<defs>.*?</defs>', text_of(path))[0] for path in DRAWINGS}
    report('all pictures have one style: their <defs> are the same',
           [] if len(styles) == 1 else ['%d styles' % len(styles)])
    with open(os.path.join(MANUAL, 'gsmbp.info'), encoding='ascii', errors='replace') as f:
        lines = {line.strip() for line in f}
    report('in info each picture is its text',
           [text for found in pictures.values() for _, text in found if '[%s]' % text not in lines])


if __name__ == '__main__':
    main()
