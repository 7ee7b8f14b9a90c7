;;; kernel/progress.lisp: a derivation that takes long says on the terminal what it is doing, a line
;;; a stage; a quick one says nothing.
(in-package :maxima)

(defvar *gs-patience* 10)             ; seconds until the first word, half of that until another
(defvar *gs-next* 10)                 ; seconds after which the next word is due
(defvar *gs-began* nil)               ; when the work began, nil outside of it
(defvar *gs-who* "")
(defvar *gs-stage* nil)               ; the stage of which nothing has been said yet
(defvar *gs-ticks* 0)

;;; gs__telling(who, f): f(); meanwhile a stage is told, once, where nothing has been said for so
;;; long
(defun $gs__telling (who f)
  (if *gs-began*
      (mfuncall f)
      (let ((*gs-began* (get-internal-real-time)) (*gs-who* who) (*gs-stage* nil)
            (*gs-ticks* 0) (*gs-next* *gs-patience*))
        (mfuncall f))))
;;; gs__stage(text): what comes now
(defun $gs__stage (text)
  (setq *gs-stage* text)
  (gs-tell))
;;; called for every name and every statement: looks at the clock now and then
(defun gs-tick ()
  (when *gs-stage*
    (incf *gs-ticks*)
    (when (>= *gs-ticks* 50) (setq *gs-ticks* 0) (gs-tell))))
(defun gs-tell ()
  (when (and *gs-began* *gs-stage*)
    (let ((s (floor (- (get-internal-real-time) *gs-began*) internal-time-units-per-second)))
      (when (>= s *gs-next*)
        (format t "gsmbp: ~a: ~a (~d s so far)~%" *gs-who* *gs-stage* s)
        (finish-output)
        (setq *gs-stage* nil *gs-next* (+ s (ceiling *gs-patience* 2)))))))
