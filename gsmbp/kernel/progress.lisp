;;; kernel/progress.lisp: a derivation that takes long says on the terminal what it is doing and
;;; about how long it will take yet, in a line that the next one overwrites; a quick one says
;;; nothing, nor does one whose output is no terminal.
(in-package :maxima)

(defvar *gs-patience* 10)             ; seconds until the first word, half of that until another
(defvar *gs-next* 10)                 ; seconds after which the next word is due
(defvar *gs-began* nil)               ; when the work began, nil outside of it
(defvar *gs-who* "")
(defvar *gs-stage* nil)               ; the stage of which nothing has been said yet
(defvar *gs-ticks* 0)
(defvar *gs-stages* 0)                ; how many there are about, and how many have begun
(defvar *gs-begun* 0)
(defvar *gs-told* nil)                ; a line stands on the terminal
(defvar *gs-terminal* :unknown)       ; a stream, or nil

;;; where GSMBP_TELL says (share/make/derive, whose standard output is a log), or standard output
(defun gs-terminal ()
  (when (eq *gs-terminal* :unknown)
    (let ((file (maxima-getenv "GSMBP_TELL")))
      (setq *gs-terminal*
            (cond ((and file (plusp (length file)))
                   (ignore-errors (open file :direction :output :if-exists :append)))
                  ((eql 0 (ignore-errors (mfuncall '$system "test -t 1"))) *standard-output*)))))
  *gs-terminal*)
(defun gs-line (text)
  (format *gs-terminal* "~a~a~a[K" (code-char 13) text (code-char 27))
  (finish-output *gs-terminal*)
  (setq *gs-told* (plusp (length text))))

;;; gs__telling(who, f): f(); meanwhile a stage is told, once, where nothing has been said for so
;;; long
(defun $gs__telling (who f)
  (if *gs-began*
      (mfuncall f)
      (let ((*gs-began* (get-internal-real-time)) (*gs-who* who) (*gs-stage* nil)
            (*gs-ticks* 0) (*gs-next* *gs-patience*) (*gs-stages* 0) (*gs-begun* 0) (*gs-told* nil))
        (unwind-protect (mfuncall f)
          (when *gs-told* (gs-line ""))))))
;;; gs__stages(n): there will be about n of them, of the same length about
(defun $gs__stages (n)
  (setq *gs-stages* n)
  '$done)
;;; gs__stage(text): what comes now
(defun $gs__stage (text)
  (setq *gs-stage* text)
  (incf *gs-begun*)
  (gs-tell))
;;; called for every name and every statement: looks at the clock now and then
(defun gs-tick ()
  (when *gs-stage*
    (incf *gs-ticks*)
    (when (>= *gs-ticks* 50) (setq *gs-ticks* 0) (gs-tell))))
(defun gs-tell ()
  (when (and *gs-began* *gs-stage*)
    (let ((s (floor (- (get-internal-real-time) *gs-began*) internal-time-units-per-second)))
      (when (and (>= s *gs-next*) (gs-terminal))
        (gs-line (format nil "gsmbp: ~a: ~a (~d s so far~a)" *gs-who* *gs-stage* s (gs-left s)))
        (setq *gs-stage* nil *gs-next* (+ s (ceiling *gs-patience* 2)))))))
;;; by the share of the stages that are behind
(defun gs-left (s)
  (let ((done (1- *gs-begun*)))
    (if (< 0 done *gs-stages*)
        (format nil ", about ~d s left" (ceiling (* s (- *gs-stages* done)) done))
        "")))
