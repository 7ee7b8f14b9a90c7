;;; gsmbp_lists.lisp: small functions on lists and exact numbers that a derivation calls thousands
;;; of times (see gsmbp_util.mac), in Lisp.
(in-package :maxima)
(defvar $gsmbp__joint_table)

;;; the lists of a list, one behind the other; the sum of a list of terms
(defun $gsmbp__flat (l)
  (let ((all nil))
    (dolist (x (cdr l) (gsmbp-list (nreverse all)))
      (unless ($listp x) (merror "gsmbp: a list of lists is expected; found: ~M" x))
      (setq all (revappend (cdr x) all)))))
(defun $gsmbp__sum (l) (addn (cdr l) nil))

;;; [the first n of l, the others]; the nthcdr of GCL is recursive, and with it Maxima's firstn and
;;; rest: they fail beyond some thousand elements
(defun $gsmbp__cut_at (l n)
  (let ((front nil) (back (cdr l)))
    (dotimes (k n) (push (pop back) front))
    (gsmbp-list (list (gsmbp-list (nreverse front)) (gsmbp-list back)))))

(defun $gsmbp__zero_matrix () (gsmbp-list (loop repeat 3 collect (gsmbp-list (list 0 0 0)))))
(defun $gsmbp__identity ()
  (gsmbp-list (list (gsmbp-list (list 1 0 0)) (gsmbp-list (list 0 1 0)) (gsmbp-list (list 0 0 1)))))

;;; position of the first element of l that is x, or 0
(defun $gsmbp__position (x l)
  (let ((k 0)) (dolist (y (cdr l) 0) (incf k) (when (alike1 x y) (return k)))))

;;; the first row of a table (a list of lists) that begins with the symbol key, else false
(defun $gsmbp__row_of (table key) (find key (cdr table) :key #'cadr))

;;; ---------------------------------------------------------------------------------- exact numbers

;;; The rational of the fewest decimal digits that rounds to the double x: 0.1 => 1/10, 1.0e-4 =>
;;; 1/10000. Worked out in exact arithmetic (the printer of GCL is not exact): x = 0.1 + 0.2 =>
;;; 30000000000000004/10^17.
(defun gsmbp-decimal (x)
  (if (zerop x)
      0
      (multiple-value-bind (m e) (integer-decode-float (abs x))
        (let* ((r (* m (expt 2 e))) (n (+ (integer-length m) e -1)) (h (gsmbp-half-ulp r n))
               (d (gsmbp-log10 r n)))
          (do ((k 0 (1+ k)))
              (nil)
            (let* ((c (* (round (* r (expt 10 (- k d)))) (expt 10 (- d k)))) (apart (abs (- c r))))
              (when (or (< apart h) (and (= apart h) (evenp (/ r (* 2 h)))))
                (return (if (minusp x) (- c) c)))))))))
;;; half the width of the numbers that round to r, n = floor(log2(r))
(defun gsmbp-half-ulp (r n) (expt 2 (- (max (- n 52) -1074) (if (= r (expt 2 n)) 2 1))))
;;; floor(log10(r))
(defun gsmbp-log10 (r n)
  (let ((d (floor (* n 30103) 100000)))
    (do () ((> (expt 10 (1+ d)) r)) (incf d))
    (do () ((<= (expt 10 d) r) d) (decf d))))

;;; The expression e with every float and bigfloat in it replaced by its exact decimal; lists,
;;; matrices and equations are entered as well. Nothing is evaluated.
(defun $gsmbp__exact (e)
  (cond ((floatp e)
         (let ((q (gsmbp-decimal e)))
           (if (integerp q) q (list '(rat simp) (numerator q) (denominator q)))))
        ((or (atom e) (not (gsmbp-inexact-p e))) e)
        ((eq (caar e) 'bigfloat) (mfuncall '$gsmbp__decimal e))
        ((eq (caar e) 'mrat) ($gsmbp__exact ($ratdisrep e)))
        (($mapatom e) e)
        (t (simplifya (cons (list (caar e)) (mapcar #'$gsmbp__exact (cdr e))) nil))))
(defun gsmbp-inexact-p (e)
  (cond ((atom e) (floatp e))
        ((member (caar e) '(bigfloat mrat)) t)
        (t (some #'gsmbp-inexact-p (cdr e)))))

;;; An expression as it was typed, not simplified, with exact numbers for the decimals that meet
;;; other numbers: 0.1*3 becomes 3/10, not 0.30000000000000004. A decimal alone stays as it is (and
;;; is shown so in messages).
(defun gsmbp-typed (e calculated)
  (cond ((floatp e) (if calculated ($gsmbp__exact e) e))
        ((or (atom e) (member (caar e) '(bigfloat mrat rat)) (not (gsmbp-inexact-p e))) e)
        (t (let ((inside (and (member (caar e) '(mplus mtimes mexpt mquotient mminus mdifference))
                              (or calculated (> (gsmbp-typed-numbers e) 1)))))
             (cons (list (caar e)) (mapcar #'(lambda (x) (gsmbp-typed x inside)) (cdr e)))))))
;;; how many numbers an expression calculates with; the exponent of a symbol is none
(defun gsmbp-typed-numbers (e)
  (cond ((numberp e) 1)
        ((atom e) 0)
        ((member (caar e) '(rat bigfloat)) 1)
        ((and (eq (caar e) 'mexpt) (symbolp (cadr e))) 0)
        (t (loop for x in (cdr e) sum (gsmbp-typed-numbers x)))))
;;; The elements are neither evaluated nor simplified before their decimals are exact, which no
;;; function of Maxima's language can do.
(defmspec $gsmbp_scene (form)
          (let ((elements (mapcar #'(lambda (x) (gsmbp-typed x nil)) (cddr form))))
            (unless (cdr form)
              ($gsmbp__raise
                "gsmbp_scene: expected gsmbp_scene(name, element, ...); found no argument"))
            (gsmbp-apart
              #'(lambda ()
                  (gsmbp-need-simple elements)
                  (mfuncall '$gsmbp__scene_typed (meval (cadr form))
                            (simplify (cons '(mlist) elements)))))))

;;; ---------------------------------------------------------------------------- freedoms of a joint

;;; Kinds and directions of the freedoms of a joint (gsmbp_joints.mac), orient resolved: [[kind,
;;; unit vector], ...]
;;; j: gsmbp__joint(name, type, ..., axis, second_, pitch_, orientation_, coordinates, speeds, ...)
(defun $gsmbp__freedom_kinds (j)
  (let ((l nil) (orientation (nth 12 j)))
    (dolist (f (cdr (nth 4 ($gsmbp__row_of $gsmbp__joint_table (nth 2 j))))
               (gsmbp-list (nreverse l)))
      (destructuring-bind (kind word) (cdr f)
        (cond ((not (eq kind '$orient)) (push (gsmbp-list (list kind (gsmbp-direction j word))) l))
              ((eq orientation '$euler_parameters)
               (push (gsmbp-list (list '$ball (gsmbp-list (list 0 0 1)))) l))
              (t (dolist (e (cdr orientation)) (push (gsmbp-list (list '$turn e)) l))))))))
(defun gsmbp-direction (j word)
  (case word ($axis (nth 9 j)) ($second (nth 10 j)) (t (mfuncall '$gsmbp__joint_direction j word))))

;;; Freedoms of a joint, structures gsmbp__freedom(kind, direction, coordinates, speeds, pitch_),
;;; from the parent on.
(defun $gsmbp__freedoms (j)
  (let ((q (cdr (nth 13 j))))
    (flet ((take (n) (gsmbp-list (loop repeat n while q collect (pop q)))))
      (gsmbp-list
        (mapcar #'(lambda (f)
                    (destructuring-bind (kind direction) (cdr f)
                      (if (eq kind '$ball)
                          (list '($gsmbp__freedom simp)
                                kind
                                direction
                                (take 4)
                                (nth 14 j)
                                (nth 11 j))
                          (list '($gsmbp__freedom simp)
                                kind
                                direction
                                (take 1)
                                (gsmbp-list nil)
                                (nth 11 j))))) (cdr ($gsmbp__freedom_kinds j)))))))

;;; ------------------------------------------------------------------------------------------ texts

(defun $gsmbp__print_lines (stream lines)
  (dolist (l (cdr lines)) (write-string l stream) (terpri stream)))

;;; true if the list of texts holds s, whatever the case
(defun $gsmbp__holds_text (texts s) (and (member s (cdr texts) :test #'string-equal) t))

;;; The first two of the names [symbol, ...] that are the same when case is ignored, or false
(defun $gsmbp__first_collision (names)
  (let ((known (make-hash-table)))
    (dolist (x (cdr names))
      (let* ((text ($sconcat (cadr x))) (key (gsmbp-text-key text))
             (old (assoc text (gethash key known) :test #'string-equal)))
        (when old (return (gsmbp-list (list (cdr old) x))))
        (push (cons text x) (gethash key known))))))

;;; [c, e] of an expression c*e with a number c in front, [1, e] of any other
(defun $gsmbp__number_apart (e)
  (gsmbp-list (if (and (consp e) (eq (caar e) 'mtimes) (mnump (cadr e)))
                (list (cadr e) (gsmbp-multiply (cddr e)))
                (list 1 e))))

;;; what a floating point number has behind the point
(defun $gsmbp__fraction (x) (- x (floor x)))
