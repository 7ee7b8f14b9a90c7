# Modules for Python whose runs carry derivatives, and the adjoint (tests/python/derivatives.py):
# a pendulum against reference values, a closed chain, a digital controller, events.
. tests/tools/check.sh
root=$PWD
work_folder
python=/usr/bin/python3
python_packages ', requests' case_d1a sensitivity_crank sensitivity_sampled sensitivity_bounce \
  sensitivity_ball
python_modules 'gsmbp_package(scene, python, [all, adjoint, sensitivity]) of five scenes'
export PYTHONPATH="$work"
timeout 200 $python tests/python/derivatives.py tests/data/D1a_pendulum/reference.json
told $? 'derivatives.py ends'
stubs_are_python
