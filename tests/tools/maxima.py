"""Maxima for tests that talk to it: the image in which GSMBP is loaded where there is one, and no
file of the user's."""
import os
import subprocess


def maxima(root, image=True):
    """(the words of the command, whether GSMBP is loaded in it)"""
    start = image and subprocess.run(
        [root + '/share/make/image', 'start', root + '/gsmbp/gsmbp.mac'], check=False,
        stdout=subprocess.PIPE, text=True).stdout.strip()
    return [start or os.environ.get('MAXIMA', 'maxima'), '--init-mac=/dev/null',
            '--init-lisp=/dev/null'], bool(start)
