;;; routines/arguments.lisp: the arguments of emitted subroutines, and where their elements stand.
(in-package :maxima)

;;; [[symbol, "NAME(base + 1)"], ...] of symbols; [["NAME(base + 1)", e], ...] of a list;
;;; [["NAME(1,1)", e], ...] of a matrix, by columns
(defun gsmbp-places (name n base)
  (loop for k from 1 to n collect (format nil "~a(~d)" name (+ base k))))

(defun $gsmbp__s_list (symbols name base)
  (gsmbp-list
    (mapcar #'(lambda (s p) (gsmbp-list (list s p))) (cdr symbols)
            (gsmbp-places name (length (cdr symbols)) base))))

(defun $gsmbp__r_list (name l base)
  (gsmbp-list
    (mapcar #'(lambda (e p) (gsmbp-list (list p e))) (cdr l)
            (gsmbp-places name (length (cdr l)) base))))

(defun $gsmbp__r_matrix (name a)
  (let ((j 0) (l nil))
    (dolist (c (if (cdr a) (cdr ($gsmbp__transpose a))) (gsmbp-list (nreverse l)))
      (let ((i 0))
        (incf j)
        (dolist (e (cdr c))
          (incf i)
          (push (gsmbp-list (list (format nil "~a(~d,~d)" name i j) e)) l))))))
