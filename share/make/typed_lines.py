"""Does what is typed in Maxima, Octave or a shell go on in the next line?"""
import re


def goes_on(program, typed):
    if program == 'shell':
        return typed.endswith('\\')
    if program == 'maxima':
        return not typed.startswith('?') and re.search(r'[;$]\s*$', typed) is None
    bare = re.sub(r"\"[^\"\n]*\"|'[^'\n]*'(?=[\s,;)\]}])", '', typed)
    words = re.findall(r'(?<![\w.])(for|if|while|do|function|end\w*)\b', bare)
    opened = sum(-1 if w.startswith('end') else 1 for w in words if w != 'do')
    if re.match(r'\s*(for|if|while|function)\b', bare) and opened > 0:
        return True
    depth = sum(bare.count(c) for c in '([{') - sum(bare.count(c) for c in ')]}')
    return depth > 0 or bare.rstrip().endswith('...')
