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

;;; ------------------------------------------------------------------------------------------ units

;;; "q1, q2 [rad], q3 [m]": names of which those that follow each other share a unit; of more than
;;; twenty the first nineteen and the last
(defun $gs__in_units (names units)
  (let* ((names (cdr names)) (units (cdr units)) (n (length names)) (long (> n 20)))
    (flet ((kept (l) (if long (append (subseq l 0 19) (last l)) l)))
      (if (zerop n) "none [1]"
        (let ((texts
                (loop for (name . others) on (kept names) for (unit next) on (kept units)
                      for k from 1
                      collect (if (or (null others) (not (alike1 unit next)) (and long (= k 19)))
                                  (gs-text ($sconcat name) (gs-in-brackets unit))
                                  ($sconcat name)))))
          (gs-joined (if long (append (butlast texts) (list "...") (last texts)) texts) ", "))))))
(defun gs-in-brackets (unit) (gs-text " [" (if (string= unit "") "SI" unit) "]"))

;;; the units of the rates of quantities
(defun $gs__rates_of (units) (gs-list (mapcar #'$gs__rate_of (cdr units))))
(defun $gs__rate_of (unit)
  (flet ((has (part) (search part unit)) (with (new old) ($ssubst new old unit)))
    (cond ((string= unit "") "")
          ((string= unit "1") "1/s")
          ((has "/s^2") (with "/s^3" "/s^2"))
          ((has "/s") (with "/s^2" "/s"))
          ((has "/") (gs-text "(" unit ")/s"))
          (t (gs-text unit "/s")))))
