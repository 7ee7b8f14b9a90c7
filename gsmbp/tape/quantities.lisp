;;; tape/quantities.lisp: scalars, vectors, matrices of the mechanics that name themselves. The
;;; namer (tape/namer.mac) is bound once for a stage, gs__naming; the hint, the quantity's letters,
;;; is required: F : gs__named("f", gs__cross(e, h)).
(in-package :maxima)

(defun gs-naming ()
  (if (boundp '$gs__naming)
      (symbol-value '$gs__naming)
      (mfuncall '$gs__error "gs__named" "no namer is bound for this stage")))

;;; Quantities whose symbols on the tape begin with their letters, as those with a number do (w3):
;;; the others have numbers, z1, z2, ... Symbols decide which of equal choices the passes take
;;; (tape/factor.lisp).
(defvar *gs-lettered* '("ee" "ww" "len" "touch" "kinetic" "potential" "phic" "gam" "m"))
(defun gs-stem (hint)
  (if (or (some #'digit-char-p hint) (member hint *gs-lettered* :test #'string=)) hint ""))

;;; the name of a quantity: a scalar (index: text for which of several), a 3-vector, or a matrix
;;; (rows)
(defun $gs__named (hint e &optional index)
  (declare (ignore index))
  (let ((nm (gs-naming)) (stem (gs-stem hint)))
    (cond ((not ($listp e)) (gs-name-one nm e stem))
          ((and (cdr e) ($listp (cadr e))) ($gs__name_matrix nm e stem))
          (t ($gs__name_vector nm e stem)))))

;;; a symmetric matrix, its upper half named
(defun $gs__named_symmetric (hint a &optional index)
  (declare (ignore index))
  ($gs__symmetric (gs-naming) a (gs-stem hint)))

;;; a list of scalars, told apart by their numbers in it
(defun $gs__named_list (hint l)
  (declare (ignore hint))
  ($gs__name_list (gs-naming) l))

;;; The entries of M that a column, the wrench [f, n] of the direction d, has with the screws
;;; [direction, factor of f, factor of n], in place
(defun $gs__add_screw_entries (m d screws f n)
  (let ((column (append (cdr f) (cdr n))))
    (dolist (o (cdr screws) m)
      (destructuring-bind (direction a b) (cdr o)
        ($gs__add_to_matrix
          m d direction
          ($gs__named "mm" (gs-inner (append (cdr a) (cdr b)) column)
                      (gs-list (list (gs-rate-number d) (gs-rate-number direction)))))))))
;;; of the structure gs__direction(kind, axis, moves): the number of its first rate
(defun gs-rate-number (d) (cadr (cadr (nth 3 d))))
