;;; kernel/progress.lisp: a derivation that takes long says on the terminal what it is doing, a line
;;; a stage; a quick one says nothing.
(in-package :maxima)

(defvar *gsmbp-patience* 10)             ; seconds until the first word, half of that until another
(defvar *gsmbp-next* 10)                 ; seconds after which the next word is due
(defvar *gsmbp-began* nil)               ; when the work began, nil outside of it
(defvar *gsmbp-who* "")
(defvar *gsmbp-stage* nil)               ; the stage of which nothing has been said yet
(defvar *gsmbp-ticks* 0)

;;; gsmbp__telling(who, f): f(); meanwhile a stage is told, once, where nothing has been said for so
;;; long
(defun $gsmbp__telling (who f)
  (if *gsmbp-began*
      (mfuncall f)
      (let ((*gsmbp-began* (get-internal-real-time)) (*gsmbp-who* who) (*gsmbp-stage* nil)
            (*gsmbp-ticks* 0) (*gsmbp-next* *gsmbp-patience*))
        (mfuncall f))))
;;; gsmbp__stage(text): what comes now
(defun $gsmbp__stage (text)
  (setq *gsmbp-stage* text)
  (gsmbp-tell))
;;; called for every name and every statement: looks at the clock now and then
(defun gsmbp-tick ()
  (when *gsmbp-stage*
    (incf *gsmbp-ticks*)
    (when (>= *gsmbp-ticks* 50) (setq *gsmbp-ticks* 0) (gsmbp-tell))))
(defun gsmbp-tell ()
  (when (and *gsmbp-began* *gsmbp-stage*)
    (let ((s (floor (- (get-internal-real-time) *gsmbp-began*) internal-time-units-per-second)))
      (when (>= s *gsmbp-next*)
        (format t "gsmbp: ~a: ~a (~d s so far)~%" *gsmbp-who* *gsmbp-stage* s)
        (finish-output)
        (setq *gsmbp-stage* nil *gsmbp-next* (+ s (ceiling *gsmbp-patience* 2)))))))
