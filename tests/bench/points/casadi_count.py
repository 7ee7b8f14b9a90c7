"""Operations of J and (dJ/dt) u of the arm of arm.mac as CasADi has them: the chain written by hand
with its symbols, J of the place by its derivative, columns of axes, (dJ/dt) u by its forward
derivative, cse over both. Prints multiplications, additions, sines and cosines."""
import casadi as ca

COUNTED = {ca.OP_MUL: 0, ca.OP_SQ: 0, ca.OP_TWICE: 0, ca.OP_ADD: 1, ca.OP_SUB: 1, ca.OP_SIN: 2,
           ca.OP_COS: 2}


def turn_z(a):
    return ca.vertcat(ca.horzcat(ca.cos(a), -ca.sin(a), 0), ca.horzcat(ca.sin(a), ca.cos(a), 0),
                      ca.horzcat(0, 0, 1))


def turn_y(a):
    """about -y"""
    return ca.vertcat(ca.horzcat(ca.cos(a), 0, -ca.sin(a)), ca.horzcat(0, 1, 0),
                      ca.horzcat(ca.sin(a), 0, ca.cos(a)))


def vector(entries):
    v = ca.SX(3, 1)
    for k, x in entries.items():
        v[k] = x
    return v


q, u, P = ca.SX.sym('q', 6), ca.SX.sym('u', 6), ca.SX.sym('P', 6)
d1, a2, a3, d3, d4, h = [P[i] for i in range(6)]
chain = [(turn_z, {}), (turn_y, {2: d1}), (turn_y, {0: a2}), (turn_z, {0: a3, 1: -d3}),
         (turn_y, {2: d4}), (turn_z, {})]
R, p, axes = ca.SX.eye(3), ca.SX(3, 1), []
for k, (turn, at) in enumerate(chain):
    p += R @ vector(at)
    axes.append(R @ vector({2: 1} if turn is turn_z else {1: -1}))
    R = R @ ca.sparsify(turn(q[k]))
p += R @ vector({2: h})
J = ca.vertcat(ca.jacobian(p, q), ca.horzcat(*axes))
f = ca.Function('f', [q, u, P], ca.cse([J, ca.jtimes(J @ u, q, u)]))
count = [0, 0, 0]
for k in range(f.n_instructions()):
    if f.instruction_id(k) in COUNTED:
        count[COUNTED[f.instruction_id(k)]] += 1
print(*count)
