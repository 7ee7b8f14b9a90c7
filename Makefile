# GSMBP: derive, emit, compile, run, plot.  GNU make; `make help` lists the targets.

EXAMPLES := $(notdir $(patsubst %/run.m,%,$(wildcard examples/*/run.m)))
SYSTEMS  := $(basename $(notdir $(wildcard tests/bench/systems/*.mac)))
MAXIMA_SOURCES := $(shell find gsmbp share -name '*.mac' -o -name '*.lisp' | \
                    grep -v -e '/compiled/' -e gsmbp-index) \
                  share/make/maxima share/make/derive
GENERATED      := maxima.texi octave.texi entries.texi elements.texi laws.texi units.texi \
                  version.texi fields.texi options.texi methods.texi
RUN_SOURCES    := $(shell find octave share/fortran -type f 2>/dev/null)

# where `make install` puts things: the user's Maxima folder, or $(DESTDIR)$(PREFIX)/share when
# PREFIX is given
MAXIMA_USERDIR ?= $(if $(HOME),$(HOME)/.maxima)
PREFIX  :=
DESTDIR :=

.DELETE_ON_ERROR:
.SUFFIXES:
.SECONDARY:
.SECONDEXPANSION:
.PHONY: help packages packages-test compiled examples test check test-processors test-whole \
        test-random test-malformed test-identify test-writers test-reach test-c test-precision \
        test-lineage test-before test-sweep test-mpi gate bench bench-c bench-loops bench-passages \
        bench-devices bench-stiff bench-abbreviate bench-flexible bench-sensitivity bench-runs \
        bench-long bench-index2 bench-ensemble bench-sweep bench-control bench-collocation \
        bench-points bench-poses bench-reach bench-robots bench-peers same architecture doc manual \
        install uninstall package clean packages-manual packages-pdf packages-report packages-screen \
        check-environment check-report check-screen check-notebook check-portable packages-fmu \
        check-fmu packages-mpi packages-slurm check-slurm packages-cross

define HELP
make examples              derive, emit, compile, run and plot the examples
make test                  all tests; the last line is "N passed, N failed"
make check                 the core of every folder, for people at work (tests/check.txt)
make check-environment     the same a year from now, in Turkish, in another time zone with
                           umask 077, offline, not as root: the same counts in all
make test-processors       tests of numbers (tests/processors.txt) with code for x86-64, without fused
                           multiply-add, and for x86-64-v3; PROCESSORS="x86-64": these only
make test-whole            all tests at length, before a release: all of what make test takes a part
                           of
make test-random           2000 scenes made by chance against each of two independent formulations
                           (make test takes 30 and 6), 300 expressions, literal beside emitted (40),
                           and 200 scenes beside twins of the same physics (10); SEED=1 COUNT=2000:
                           others
make test-malformed        300 malformed scenes against their verdicts, mutants of the examples, 6000
                           values of wrong types in options (make test takes 25, and 100)
make test-c                emitted C against emitted Fortran of all scenes (make test takes a
                           sample); SCENES="FILE.mac ...": these only; PRECISION=quad: both in quad
                           precision
make test-precision        the run time in C in quad and in single precision, on a Cortex-M4F and an
                           AVR, emulated (make test takes a part)
make test-lineage          programs in Fortran alone of all scenes, built without a compiler of C, beside
                           emitted C (make test takes a sample)
make test-before           some 4200 runs of all scenes by every method against those of an earlier
                           commit (make test takes a share); SCENES=NAME: scenes with this in
                           their names
make test-reach            inverse kinematics of 45 arms: 1e6 poses by chance each (1e4 where
                           solutions are eigenvalues), there and back, and beside singular ones;
                           ARMS="puma scara": these only; SEED, COUNT
make test-identify         total least squares: 1000 repeats with noise in positions and efforts
                           against the Cramer-Rao bound (make test: 20); COUNT
make test-sweep            a sweep on disk killed at 30 instants by chance loses no finished chunk
                           (make test: at 3); SEED, COUNT
make test-writers          every writer of files: killed at ten instants, on full disks of six
                           sizes, twice at once, onto what is no regular file, without permission
                           (make test takes a part); SEED
make test-mpi              the program of a sweep under mpirun -n 2, a rank killed at 10 instants by
                           chance: the table of one rank; SEED, COUNT
make check-slurm           the same by the script for Slurm, in a cluster of this machine's own
                           (as root)
make gate                  may the run time in C take the place of the Fortran run time: speed and
                           errors of whole runs by both; SCENES="event_arm ...": these only
make bench-c               speed of emitted C beside emitted Fortran, of the module of Python
                           beside C
make bench                 tests/bench/report.md, report.json and figures
                           PEERS=1: SymPy, CasADi, Pinocchio, MuJoCo, EAIK from PyPI beside
                           BENCH_SYSTEMS="puma3 puma6": these only
make bench-loops           tests/bench/loops.md: every way to integrate a loop on every example with
                           loops, hard cases, SUNDIALS beside
make bench-passages        tests/bench/passages.md: ten passages of singular positions
                           RUNS=1600: all; SEED
make bench-devices         tests/bench/devices.md: full and reduced motors, speed against error;
                           every example: energy audit, speed, global error; then bench-stiff
make bench-stiff           tests/bench/stiff.md: every example by dp853, radau, CVODE and ARKODE,
                           the least time within an error; STIFF="puma560 hooke": these only
make bench-index2          tests/bench/index2.md: radau, loops in index 2 and by the equations with
                           multipliers: steps, turns, time, error; stiff springs in loops
make bench-abbreviate      tests/bench/abbreviate.md: the PUMA with the terms that matter, speed and
                           error beside the whole
make bench-flexible        tests/bench/flexible.md: a two-link arm that bends, operations; models of
                           beams beside a geometrically exact one, errors
make bench-sensitivity     tests/bench/sensitivity.md: derivatives by parameters beside runs
                           alone and central differences, an adjoint of 40
make bench-runs            tests/bench/runs.md: what output times cost, the energy of long runs
make bench-long            tests/bench/long.md: 1e7 steps of the unforced four-bar by method gauss:
                           energy, loops, memory; STEPS=1e6: fewer
make bench-ensemble        tests/bench/ensemble.md: many runs, in lanes beside one by one
make bench-sweep           tests/bench/sweep.md: a sweep of 1e5 runs beside its integration; memory
make bench-control         tests/bench/control.md: every design of controllers on a machine with
                           limits, friction, samples, steps and delay, and where it fails
make bench-collocation     tests/bench/collocation.md: the program of an optimal motion, set up
                           and evaluated; PEERS=1: CasADi from PyPI beside
make bench-points          tests/bench/points.md: J and (dJ/dt) u of a six-axis arm, operations
                           PEERS=1: CasADi and Pinocchio from PyPI beside
make bench-poses           tests/bench/poses.md: place, axes and J of a tool in one routine;
                           PEERS=1: CasADi from PyPI beside
make bench-reach           tests/bench/reach.md: all solutions of the PUMA 560 beside its inverse
                           dynamics (make bench has it, too); PEERS=1: EAIK from PyPI beside
make bench-robots PEERS=1  tests/bench/robots.md: real robots from URDF (PyPI: example-robot-data)
                           beside Pinocchio; ROBOTS="panda pr2": these only
make bench-peers           tests/bench/peers.md and figures: whole runs of the PUMA, of six general
                           links, of a slider-crank, time against error beside SciPy, MuJoCo,
                           Drake and CasADi's code in the same integrator, all from PyPI (make
                           bench PEERS=1 has it, too); BENCH_SYSTEMS="puma6": this only
make architecture          lines and bytes of the program below the JSON, folder by folder, in the
                           commit of tests/data/before/base and now
make same BASE=COMMIT      is the Fortran of every scene byte for byte what COMMIT emitted?
make check-report          the page of a run of every example, opened in a browser (headless
                           Chromium): no error, every equation laid out, the player moves
                           REPORTS="stewart four_bar": these only
make check-notebook        the tutorial's notebook runs as a whole in Jupyter, from PyPI
make check-portable        Debian 12 and 13 and a Debian with what Ubuntu 24.04 has, in chroots: all
                           examples, tests, the same texts, by Maxima on SBCL and ECL, too (as root;
                           hours); PLACES="debian-13": these only
make check-screen          the manual in Octave's doc and the notebook in wxMaxima, on a virtual
                           screen
make check-fmu             the FMUs of every example, both standards and kinds: FMPy from PyPI in an
                           environment of its own, sanitizer, wrong calls, binaries
                           FMUS="stewart four_bar": these only
make fortran_out/NAME.f    Fortran and JSON of an example or of a system of tests/bench/systems
make doc                   the manual: share/manual/gsmbp.info (? and ?? in Maxima), .html, .pdf
make manual                info alone, without TeX
make install               load("gsmbp") by name in your Maxima ($(MAXIMA_USERDIR));
                           or PREFIX=/usr/local, DESTDIR=...; says the addpath of Octave, too
make uninstall             takes away what `make install` put (the same PREFIX, DESTDIR)
make package               share/package/gsmbp-VERSION.tar.gz for `pkg install` of Octave: with the
                           Maxima part, the run time, tests (`pkg test gsmbp`)
make clean                 removes what make generated
MAXIMA=maxima-sage make ...
                           derives with Maxima on ECL instead of the default `maxima` (GCL): the
                           same text, several times slower
examples, test and bench first install the Debian packages that are missing (as root; otherwise
they name them, and go on without those that not everything needs).
Examples: $(EXAMPLES).
Systems: $(SYSTEMS).
endef
export HELP

help:
	@printf '%s\n' "$$HELP" | fold -s -w 100

packages:
	@share/make/packages

# with what only the tests, the manual, its PDF, the check of reports (a browser) need
packages-test packages-manual packages-pdf packages-report packages-screen packages-fmu packages-mpi \
packages-slurm packages-cross: packages-%:
	@share/make/packages $*

# the Lisp files of the package as one compiled file; does nothing if it is newer than they are
compiled: | packages
	@share/make/compile

examples: $(EXAMPLES:%=examples/%/out/finished)

# Fortran and JSON appear whole or not at all (gsmbp_fortran writes beside and renames)
DERIVED := fortran_out/%.f fortran_out/%.json fortran_out/%.dot

$(DERIVED): examples/$$*/$$*.mac $(MAXIMA_SOURCES) | packages compiled
	share/make/derive $< fortran_out

$(DERIVED): tests/bench/systems/%.mac $(MAXIMA_SOURCES) | packages compiled
	share/make/derive $< fortran_out

# the packages that an example needs and that are missing
lacks = $(shell share/make/packages lacks examples/$*/run.m)

# the driver of an example writes its tables and figures; `finished` comes last, so a broken run is
# never trusted
examples/%/out/finished: fortran_out/$$*.f fortran_out/$$*.json fortran_out/$$*.dot \
                         examples/$$*/run.m $$(wildcard examples/$$*/*.mac examples/$$*/*.m) \
                         $(wildcard examples/common/*.m) $(RUN_SOURCES)
	@mkdir -p $(@D)
	@rm -f $@
	$(if $(lacks),@echo 'examples/$* is left out: it needs $(lacks)' >&2,\
	  timeout -k 10 1800 $(OCTAVE) examples/$*/run.m </dev/null && \
	  share/make/picture fortran_out/$*.dot examples/$*/out/graph.png && touch $@)

test: packages-test
	@tests/run

check: packages-test
	@tests/run --table tests/check.txt

check-environment: packages-test
	@tests/tools/environments

PROCESSORS ?= x86-64 x86-64-v3
test-processors: packages-test
	@code=0; for processor in $(PROCESSORS); do \
	  echo "GSMBP_MARCH=$$processor"; \
	  GSMBP_MARCH=$$processor tests/run --table tests/processors.txt || code=1; \
	done; exit $$code

test-whole: packages-test
	@GSMBP_WHOLE=yes tests/run

# SEED and COUNT: other scenes or mutants, and how many
SEED ?= 1
test-random: packages-test compiled
	@tests/random/run $(or $(COUNT),2000) $(SEED)

SCENES ?= $(wildcard examples/*/*.mac tests/scenes/*.mac tests/bench/systems/*.mac)
test-c: packages-test compiled
	@GSMBP_PRECISION=$(PRECISION) tests/tools/c_pairs $(SCENES)

test-precision: packages-test packages-cross compiled
	@GSMBP_WHOLE=yes tests/run sh/precision

test-lineage: packages-test compiled
	@GSMBP_WHOLE=yes tests/run sh/lineage

test-before: packages-test compiled
	@tests/before/run check $(if $(filter command line environment,$(origin SCENES)),$(SCENES))

gate: packages-test compiled
	@tests/gate/gate.py $(if $(filter command line environment,$(origin SCENES)),$(SCENES))

test-malformed: packages-test compiled
	@{ tests/malformed/judge.py hand; \
	   tests/malformed/judge.py mutants $(SEED) $(or $(COUNT),300); \
	   tests/malformed/values.sh; } | \
	  tee /dev/stderr | awk '/^ok / { n++ } /^not ok / { bad++ } \
	    END { print n + 0 " passed, " bad + 0 " failed"; exit bad > 0 || n == 0 }'

test-reach: packages-test compiled
	@$(ONE_THREAD) tests/reach/run tests/bench/out/reach $(or $(COUNT),1000000) $(SEED) $(ARMS)

test-identify: packages-test compiled
	@GSMBP_TEST_DIR=$$(mktemp -d) GSMBP_TEST_LIMIT=7200 REPEATS=$(or $(COUNT),1000) \
	  tests/run test_total

test-sweep: packages-test compiled
	@GSMBP_TEST_DIR=$$(mktemp -d) tests/tools/sweep_kills $(or $(COUNT),30) $(SEED)

test-writers: packages-test compiled
	@tests/writers/check all $(SEED) | tee /dev/stderr | awk '/^ok / { n++ } /^not ok / { bad++ } \
	    END { print n + 0 " passed, " bad + 0 " failed"; exit bad > 0 || n == 0 }'

test-mpi: packages-mpi compiled
	@GSMBP_TEST_DIR=$$(mktemp -d) tests/tools/sweep_ranks $(or $(COUNT),10) $(SEED)

check-slurm: packages-slurm compiled
	@GSMBP_TEST_DIR=$$(mktemp -d) tests/tools/sweep_slurm

OCTAVE := octave-cli -qf --no-history
ONE_THREAD := OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1

bench-c: packages-test compiled
	@for flags in -O2 '-O3 -march=native -ffp-contract=fast'; do \
	  tests/bench/c_speed.py $$flags || exit 1; done
	GSMBP_TIMES=yes tests/run sh/python

# $(call reported,NAME,COMMAND): the command writes tests/bench/NAME.md anew, every table with rows
define reported
@mkdir -p tests/bench/out
@rm -f tests/bench/$(1).md
$(2)
@tests/bench/filled tests/bench/$(1).md
endef

bench: packages compiled
	$(call reported,report,timeout -k 10 7200 $(OCTAVE) tests/bench/run.m </dev/null)
	$(if $(PEERS),$(MAKE) --no-print-directory bench-peers)

bench-peers: packages compiled
	@mkdir -p tests/bench/out
	@tests/bench/rivals/setup tests/bench/out/peers || \
	  echo 'bench-peers: of SymPy, CasADi, Pinocchio, MuJoCo only what is there'
	@for peer in scipy mpmath drake; do \
	  tests/bench/rivals/environment tests/bench/out/peers $$peer || \
	    echo "bench-peers: $$peer is not to be had and left out"; done
	$(call reported,peers,$(ONE_THREAD) timeout -k 10 7200 $(OCTAVE) tests/bench/peers.m </dev/null)

bench-passages: packages compiled
	$(call reported,passages,RUNS='$(RUNS)' SEED='$(SEED)' $(ONE_THREAD) \
	  timeout -k 10 21600 $(OCTAVE) tests/bench/passages.m </dev/null)

bench-loops bench-devices bench-abbreviate bench-sensitivity bench-runs bench-long bench-index2 \
bench-ensemble bench-sweep bench-control: bench-%: packages compiled
	$(call reported,$*,$(ONE_THREAD) timeout -k 10 7200 $(OCTAVE) tests/bench/$*.m </dev/null)

bench-sweep: fortran_out/slider_crank.f fortran_out/slider_crank.json

bench-devices: bench-stiff
bench-stiff: packages compiled
	$(call reported,stiff,STIFF='$(STIFF)' $(ONE_THREAD) timeout -k 10 7200 \
	  $(OCTAVE) tests/bench/stiff.m </dev/null)

bench-poses: packages compiled
	$(if $(PEERS),@tests/bench/rivals/setup tests/bench/out/peers)
	$(call reported,poses,PEERS='$(if $(PEERS),$(CURDIR)/tests/bench/out/peers)' $(ONE_THREAD) \
	  timeout -k 10 3600 $(OCTAVE) tests/bench/poses.m </dev/null)

bench-flexible bench-collocation bench-points bench-reach: bench-%: packages compiled
	$(call reported,$*,PEERS='$(PEERS)' $(ONE_THREAD) timeout -k 10 3600 \
	  tests/bench/$*/run tests/bench/out/$*)

bench-robots: packages compiled
	@[ -n '$(PEERS)' ] || { echo 'bench-robots: say PEERS=1: it takes Pinocchio and the' \
	  'robots from PyPI'; exit 1; }
	$(call reported,robots,ROBOTS='$(ROBOTS)' $(ONE_THREAD) tests/bench/robots/run)

# PATTERN: only the scenes whose path holds it
same: | packages
	@tests/tools/same '$(BASE)' '$(PATTERN)'

architecture:
	@tests/tools/architecture

check-fmu: packages-fmu compiled
	@tests/fmu/check $(FMUS)

REPORTS ?= $(EXAMPLES)

check-notebook: packages compiled
	@tests/portable/notebook tests/bench/out/notebook

# PLACES="debian-13": these only
check-portable:
	@tests/portable/check $(PLACES)

check-report: packages-report $(REPORTS:%=fortran_out/%.f) | compiled
	@tests/report/check $(REPORTS)

check-screen: packages-screen manual | compiled
	@tests/screen/check

# the manual: what is written, what the program says of itself; info with the index of Maxima's
# describe, one page of HTML, PDF (the one that needs TeX)
MANUAL := share/manual/gsmbp
MANUAL_SOURCES := $(wildcard share/manual/*.css share/manual/figures/* share/manual/pictures/*) \
                  share/make/manual \
                  share/make/doc share/make/functions share/make/functions.awk share/make/demo \
                  share/make/entries share/make/insert share/make/index.awk \
                  share/make/notebook share/make/with_pictures \
                  $(filter-out $(GENERATED:%=share/manual/%),$(wildcard share/manual/*.texi))

doc: manual $(MANUAL).html $(MANUAL).pdf
manual: $(MANUAL)-index.lisp

share/manual/functions.txt: $(MAXIMA_SOURCES) $(wildcard octave/*.m) $(MANUAL_SOURCES) \
                            share/engine/core/gsmbp/options.h share/engine/core/gsmbp/methods.h | compiled
	share/make/manual sources

$(MANUAL)-index.lisp: share/manual/functions.txt | packages-manual
	share/make/manual info

$(MANUAL).html: share/manual/functions.txt | packages-manual
	share/make/manual html

$(MANUAL).pdf: share/manual/functions.txt | packages-pdf
	share/make/manual pdf

# the manual needs programs that the rest does not
install:
	@$(MAKE) --no-print-directory manual || \
	  echo 'install: without the manual, ? and ?? in Maxima do not know GSMBP' >&2
	@share/make/compile
	@share/make/install put '$(MAXIMA_USERDIR)' '$(PREFIX)' '$(DESTDIR)'

uninstall:
	@share/make/install remove '$(MAXIMA_USERDIR)' '$(PREFIX)' '$(DESTDIR)'

package:
	@share/make/package

clean:
	rm -rf fortran_out share/package gsmbp/compiled examples/*/out tests/bench/out \
	  share/manual/functions.txt
	rm -rf share/manual/gsmbp.info share/manual/gsmbp-index.lisp share/manual/gsmbp.html \
	  octave/doc.info
	rm -rf share/manual/gsmbp-notebook.html share/manual/gsmbp-tutorial.wxm
	rm -rf share/manual/gsmbp-tutorial.ipynb
	rm -rf share/manual/gsmbp.pdf share/manual/gsmbp.demo $(GENERATED:%=share/manual/%)
	rm -rf fmu_out octave-workspace tests/bench/report.* tests/bench/loops.json \
	  tests/bench/devices.json $(wildcard tests/bench/*.md)
