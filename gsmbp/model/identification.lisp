;;; model/identification.lisp: which rows of a matrix are sums of those before them, and with which
;;; factors.
(in-package :maxima)

;;; gs__row_relations(A, tol): [numbers of the independent rows, [[number, [[number of a row
;;; before, factor], ...]], ...]] of the others. Rational numbers are taken in the field of the
;;; prime (a factor is then an integer between -p/2 and p/2), others as floats.
(defun $gs__row_relations (a tol)
  (if (every #'(lambda (r) (every #'gs-exact-p (cdr r))) (cdr a))
    (gs-relations (mapcar #'(lambda (r) (mapcar #'gs-residue (cdr r))) (cdr a))
      #'(lambda (row) (position-if-not #'zerop row))
      #'(lambda (x s y) (mod (- x (* s y)) gs-prime))
      #'(lambda (x d) (mod (* x (gs-inverse d)) gs-prime))
      #'(lambda (x) (if (> x (ash gs-prime -1)) (- x gs-prime) x)))
    (gs-relations (mapcar #'(lambda (r) (mapcar #'gs-double (cdr r))) (cdr a))
      #'(lambda (row) (let ((p (gs-largest row))) (and (> (abs (svref row p)) tol) p)))
      #'(lambda (x s y) (- x (* s y)))
      #'/
      #'(lambda (x) (let ((n (round x))) (cond ((< (abs (- x n)) tol) n) (t x)))))))

(defun gs-exact-p (x) (or (integerp x) (and (consp x) (eq (caar x) 'rat))))
(defun gs-double (x) (let ((y ($float x))) (coerce y 'double-float)))

;;; Values of outputs in the field of the prime, where code (all entries that they need) holds sums,
;;; products and whole powers only and the point [symbol = rational, ...] says the rest; else false.
(defun $gs__tape_residues (code outputs point)
  (let ((h (make-hash-table :test #'eq)))
    (catch 'other
      (dolist (e (cdr point)) (setf (gethash (cadr e) h) (gs-residue-value h (caddr e))))
      (dolist (e (cdr code))
        (unless (gethash (gs-entry-name e) h)
          (setf (gethash (gs-entry-name e) h)
                (gs-residue-value h (gs-entry-expression e)))))
      (cons '(mlist) (mapcar #'(lambda (e) (gs-residue-value h e)) (cdr outputs))))))
(defun gs-residue-value (h e)
  (cond ((gs-exact-p e) (gs-residue e))
        ((symbolp e) (or (gethash e h) (throw 'other nil)))
        ((atom e) (throw 'other nil))
        ((eq (caar e) 'mplus)
         (let ((s 0))
           (dolist (x (cdr e) s) (setq s (mod (+ s (gs-residue-value h x)) gs-prime)))))
        ((eq (caar e) 'mtimes)
         (let ((s 1))
           (dolist (x (cdr e) s) (setq s (mod (* s (gs-residue-value h x)) gs-prime)))))
        ((and (eq (caar e) 'mexpt) (integerp (caddr e)))
         (let ((x (gs-residue-value h (cadr e))) (s 1))
           (dotimes (k (abs (caddr e))) (setq s (mod (* s x) gs-prime)))
           (if (plusp (caddr e)) s (gs-inverse s))))
        (t (throw 'other nil))))

;;; By elimination: every row carries the combination of rows that it has become (a list number ->
;;; factor as a vector).
(defun gs-relations (rows pivot minus over shown)
  (let ((basis nil) (kept nil) (others nil) (number 0) (m (length rows)))
    (dolist (row rows
                 (list '(mlist) (cons '(mlist) (nreverse kept)) (cons '(mlist) (nreverse others))))
      (incf number)
      (let ((r (coerce row 'simple-vector)) (w (make-array (1+ m) :initial-element 0)))
        (setf (svref w number) 1)
        (dolist (b (reverse basis))
          (let ((s (svref r (car b))))
            (unless (zerop s)
              (dotimes (k (length r))
                (setf (svref r k) (funcall minus (svref r k) s (svref (cadr b) k))))
              (dotimes (k (1+ m))
                (setf (svref w k) (funcall minus (svref w k) s (svref (caddr b) k)))))))
        (let ((p (funcall pivot r)))
          (cond (p (let ((d (svref r p)))
                     (dotimes (k (length r)) (setf (svref r k) (funcall over (svref r k) d)))
                     (dotimes (k (1+ m)) (setf (svref w k) (funcall over (svref w k) d))))
                   (push (list p r w) basis) (push number kept))
                (t (push (list '(mlist) number (gs-factors w number minus shown)) others))))))))

;;; row = sum of factors times rows before it, where w is its combination that is zero
(defun gs-factors (w number minus shown)
  (let ((l nil))
    (do ((k (1- number) (1- k))) ((< k 1) (cons '(mlist) l))
      (let ((x (funcall shown (funcall minus 0 1 (svref w k)))))
        (unless (zerop x) (push (list '(mlist) k x) l))))))
