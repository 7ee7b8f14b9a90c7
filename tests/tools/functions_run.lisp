;;; functions_run.lisp: which functions of the package, written in Maxima's language, run. Load it
;;; behind gsmbp.mac:
;;;   gs__count_runs()    from here on every function notes that it runs
;;;   gs__functions_run() those that ran since the last call of either: [[name, times], ...]
(in-package :maxima)

(defvar *gs-runs* (make-hash-table :test 'eq))
(defun $gs__note_run (name) (incf (gethash name *gs-runs* 0)) '$done)

;;; the body of a function with a note ahead; of a public one its own body (kernel/session.lisp)
(defun gs-noting (name kind)
  (let ((e (mget name kind)))
    (when (and e (not (and (consp (third e)) (eq '$gs__apart (caar (third e))))))
      (mputprop name (list* (first e) (second e) `(($gs__note_run) ((mquote) ,name)) (cddr e))
                kind))))
(defun $gs__count_runs ()
  (dolist (f (cdr $functions))
    (when (eql 0 (search "$GS" (string-upcase (symbol-name (caar f)))))
      (gs-noting (caar f) 'mexpr)
      (gs-noting (caar f) 'gs-own)))
  (clrhash *gs-runs*)
  '$done)
(defun $gs__functions_run ()
  (let ((l nil))
    (maphash #'(lambda (name times) (push (list '(mlist simp) name times) l)) *gs-runs*)
    (clrhash *gs-runs*)
    (cons '(mlist simp) (sort l #'string< :key #'(lambda (row) (symbol-name (cadr row)))))))
