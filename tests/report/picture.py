"""A PNG of 8 bits a channel read without other packages."""
import collections
import struct
import zlib


def pixels(data):
    """rows of pixels (tuples of channels)"""
    place, packed = 8, b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        part = data[place + 8:place + 8 + length]
        place += 12 + length
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", part[:10])
            assert depth == 8 and colour in (2, 6), "expected 8 bits RGB or RGBA"
        elif kind == b"IDAT":
            packed += part
    size = {2: 3, 6: 4}[colour]
    raw, before, rows = zlib.decompress(packed), bytearray(width * size), []
    for y in range(height):
        start = y * (width * size + 1)
        line = unfiltered(raw[start], bytearray(raw[start + 1:start + 1 + width * size]), before,
                          size)
        rows.append([tuple(line[i:i + 3]) for i in range(0, len(line), size)])
        before = line
    return rows


def unfiltered(kind, line, before, size):
    """a line as it was before one of the five filters of PNG"""
    for i, value in enumerate(line):
        left = line[i - size] if i >= size else 0
        corner = before[i - size] if i >= size else 0
        line[i] = (value + predicted(kind, left, before[i], corner)) & 255
    return line


def predicted(kind, left, above, corner):
    """the number that a filter has taken away"""
    if kind < 4:
        return (0, left, above, (left + above) // 2)[kind]
    middle = left + above - corner
    return min((abs(middle - left), 0, left), (abs(middle - above), 1, above),
               (abs(middle - corner), 2, corner))[2]


def thumbnail(data, columns=48, lines=30):
    """lines of the mean brightness (0 to 255) of the cells of a grid"""
    rows = pixels(data)
    high, wide = len(rows), len(rows[0])

    def mean(i, j):
        cell = [sum(p) for row in rows[i*high//lines:(i + 1)*high//lines]
                for p in row[j*wide//columns:(j + 1)*wide//columns]]
        return round(sum(cell)/(3*len(cell)))
    return [[mean(i, j) for j in range(columns)] for i in range(lines)]


def difference(one, other):
    """of two thumbnails, beside what the second shows on its ground: 0 the same, 1 nothing of it"""
    ground = collections.Counter(x for line in other for x in line).most_common(1)[0][0]
    shown = sum(abs(x - ground) for line in other for x in line)
    return sum(abs(x - y) for a, b in zip(one, other) for x, y in zip(a, b))/max(1, shown)


def share_of_ground(data):
    """(share of the commonest colour, number of colours)"""
    counted = collections.Counter(p for row in pixels(data) for p in row)
    return counted.most_common(1)[0][1] / sum(counted.values()), len(counted)
