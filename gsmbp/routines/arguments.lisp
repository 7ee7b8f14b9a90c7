;;; routines/arguments.lisp: the arguments of emitted subroutines, and where their elements stand.
(in-package :maxima)

;;; [[symbol, place], ...] of symbols, at gs__el(name, base + 1) and on; [[place, e], ...] of a
;;; list; the same of a matrix, by columns
(defun gs-place (name &rest subscripts) (list* '($gs__el_ simp) name subscripts))
(defun gs-places (name n base)
  (loop for k from 1 to n collect (gs-place name (+ base k))))

(defun $gs__s_list (symbols name base)
  (gs-list
    (mapcar #'(lambda (s p) (gs-list (list s p))) (cdr symbols)
            (gs-places name (length (cdr symbols)) base))))

(defun $gs__r_list (name l base)
  (gs-list
    (mapcar #'(lambda (e p) (gs-list (list p e))) (cdr l)
            (gs-places name (length (cdr l)) base))))

(defun $gs__r_matrix (name a)
  (let ((j 0) (l nil))
    (dolist (c (if (cdr a) (cdr ($gs__transpose a))) (gs-list (nreverse l)))
      (let ((i 0))
        (incf j)
        (dolist (e (cdr c))
          (incf i)
          (push (gs-list (list (gs-place name i j) e)) l))))))
