"""casadi_pose.py MODEL.txt FOLDER: place, axes and Jacobian of a frame at the end of a chain as
CasADi has them (pj.c), and with (dJ/dt) u (pjd.c); lengths are parameters (par.c). The chain is
written by hand with its symbols, J of the place by its derivative, columns of axes, (dJ/dt) u by
its forward derivative, cse over all. MODEL.txt is that of rivals/model.hpp; the frame is 0.05 m,
0.02 m, 0.1 m from the last joint. Prints for each: word, multiplications, additions, sines."""
import sys

import casadi as ca

COUNTED = {ca.OP_MUL: 0, ca.OP_SQ: 0, ca.OP_TWICE: 0, ca.OP_ADD: 1, ca.OP_SUB: 1, ca.OP_SIN: 2,
           ca.OP_COS: 2}
CALL = """extern double p[];
void %s(const double *q, const double *v, const double *a, double *o) {
  const double *in[3] = {q, v, p};
  double *out[1] = {o};
  f_%s(in, out, 0, 0, 0);
}
"""
TOOL = [0.05, 0.02, 0.1]


def read(name):
    """The chain: parent, kind, axes and place of each joint in its parent."""
    words = open(name).read().split()
    n, words, chain = int(words[0]), words[4:], []
    for _ in range(n):
        row, words = words[:24], words[24:]
        number = [float(x) for x in row[2:14]]
        chain.append((int(row[0]), row[1], number[:9], number[9:]))
    return chain


def main():
    chain, folder = read(sys.argv[1]), sys.argv[2]
    n = len(chain)
    q, u = ca.SX.sym('q', n), ca.SX.sym('u', n)
    symbols, values = [], []

    def length(x):
        if x == 0:
            return ca.SX(1, 1)
        symbols.append(ca.SX.sym('p%d' % len(values)))
        values.append(x)
        return symbols[-1]
    R, p, axes = ca.SX.eye(3), ca.SX(3, 1), []
    for k, (parent, kind, axes_there, place) in enumerate(chain):
        assert parent == k - 1 and kind == 'R'
        p += R @ ca.sparsify(ca.vertcat(*[length(x) for x in place]))
        R = R @ ca.sparsify(ca.reshape(ca.SX(axes_there), 3, 3).T)
        axes.append(R[:, 2])
        c, s = ca.cos(q[k]), ca.sin(q[k])
        R = R @ ca.sparsify(ca.vertcat(ca.horzcat(c, -s, 0), ca.horzcat(s, c, 0),
                                       ca.horzcat(0, 0, 1)))
    p += R @ ca.vertcat(*[length(x) for x in TOOL])
    J = ca.vertcat(ca.jacobian(p, q), ca.horzcat(*axes))
    P = ca.vertcat(*symbols)
    for word, out in (('pj', [p, R, J]), ('pjd', [p, R, J, ca.jtimes(J @ u, q, u)])):
        out = ca.cse(ca.densify(ca.vertcat(*[ca.vec(x) for x in out])))
        f = ca.Function('f_' + word, [q, u, P], [out])
        code = ca.CodeGenerator(word + '.c')
        code.add(f)
        with open('%s/%s.c' % (folder, word), 'w') as file:
            file.write(code.dump() + CALL % (word, word))
        count = [0, 0, 0]
        for k in range(f.n_instructions()):
            if f.instruction_id(k) in COUNTED:
                count[COUNTED[f.instruction_id(k)]] += 1
        print(word, *count)
    with open(folder + '/par.c', 'w') as file:
        file.write('double p[] = {%s};\n' % ', '.join(map(repr, values)))


main()
