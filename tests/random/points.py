"""Points and frames of a scene, and their Jacobians by the independent mechanics.

They are drawn from a stream of their own: without them a scene is what it was.
"""
import random
import numpy as np
from joints import cross, skew


class Frame:
    """a place and axes of a link"""

    def __init__(self, name, link, at, R):
        self.name, self.link, self.at, self.R = name, link, at, R

    def seen(self, bodies):
        """place, axes, Jacobian by the natural speeds of the tree, accelerations where these keep
        their values; ground axes"""
        b = bodies[self.link]
        r, w = b.R @ self.at, b.twist[3:]
        J = b.J.copy()
        J[:3] -= skew(r) @ b.J[3:]
        bias = b.bias.copy()
        bias[:3] += cross(b.bias[3:], r) + cross(w, cross(w, r))
        return b.p + r, b.R @ self.R, J, bias


def add_points(scene):
    """some of the seeds have points and frames on some links, or on ground"""
    r = random.Random('points %d' % scene.seed)
    scene.points = []
    if r.random() < .5:
        return
    kept, scene.r = scene.r, r
    for k in range(r.choice([1, 1, 2, 3])):
        link = r.choice([l['name'] for l in scene.m.links] + ['ground']*(r.random() < .2))
        at, place = scene.vector(-.9, .9)
        turn, R = scene.rotation()
        kind = 'frame' if turn else 'point'
        name = 'P%d' % k
        scene.points.append(Frame(name, link, place, R))
        scene.words.append('%s(%s, %s, at = %s%s)' % (kind, name, link, at,
                                                      ', rotation = ' + turn if turn else ''))
        scene.tags.add(kind)
    scene.r = kept
