;; gsmbp_hash.lisp: hash tables on expressions, in three lines of Lisp (Maxima's own hashed arrays are ten times slower).
;; gsmbp__get gives false for a key that is not there.
(in-package :maxima)
(defun $gsmbp__new_hash () (make-hash-table :test #'equal))
(defun $gsmbp__get (h k) (values (gethash k h)))
(defun $gsmbp__put (h k v) (setf (gethash k h) v))
;; e without the marks that functions like ratsimp leave on it, so that equal expressions are equal lists
(defun $gsmbp__unmarked (e)
  (if (atom e) e (cons (if (member 'array (cdar e)) (list (caar e) 'simp 'array) (list (caar e) 'simp)) (mapcar #'$gsmbp__unmarked (cdr e)))))
