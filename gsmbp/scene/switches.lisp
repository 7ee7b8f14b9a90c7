;;; scene/switches.lisp: gs__after(t, t1), 1 from t1 on, else 0, in numbers.
(in-package :maxima)

(setf (get '$gs__after 'operators) 'gs-simp-after)
(setf (get '$gs__after 'reversealias) '$after)   ; as it is shown
(defun gs-simp-after (e ignored z)
  (declare (ignore ignored))
  (twoargcheck e)
  (let ((x (simpcheck (cadr e) z)) (y (simpcheck (caddr e) z)))
    (if (and (mnump x) (mnump y)) (if (mgrp y x) 0 1)
        (eqtest (list '($gs__after) x y) e))))
