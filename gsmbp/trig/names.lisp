;;; trig/names.lisp: angles, lists of [coordinate, integer], and the names of their sines and
;;; cosines (see trig/rules.mac).
(in-package :maxima)

;;; [[q2, 1], [q3, -2]] => q2 - 2*q3
(defun $gs__angle_value (angle)
  (addn (mapcar #'(lambda (x) (mul (caddr x) (cadr x))) (cdr angle)) nil))

;;; [sign, angle] with no zero coefficient and a positive first one: sin(angle) = sign*sin(normal
;;; angle)
(defun $gs__angle_normal (angle)
  (let ((l (remove-if #'(lambda (x) (eql (caddr x) 0)) (cdr angle))))
    (flet ((opposite (x) (gs-list (list (cadr x) (gs-minus (caddr x))))))
      (gs-list (if (and l (minusp (caddr (car l))))
                   (list -1 (gs-list (mapcar #'opposite l)))
                   (list 1 (gs-list l)))))))

;;; a + k*b of angles, the coordinates in one order (q2 before q10), so that an angle has one form
(defun $gs__angle_sum (a b k)
  (let ((sum (mapcar #'cdr (cdr a))))
    (loop for (nil q n) in (cdr b)
          do (let ((own (assoc q sum :test #'eq)) (n (mul k n)))
               (setq sum (if own
                             (substitute (list q (add (cadr own) n)) own sum :test #'eq)
                             (append sum (list (list q n)))))))
    (gs-list (mapcar #'gs-list (stable-sort (remove 0 sum :key #'cadr) #'gs-ahead-p)))))
(defun gs-ahead-p (x y)
  (let ((s ($sconcat (car x))) (u ($sconcat (car y))))
    (if (= (length s) (length u)) ($orderlessp s u) (< (length s) (length u)))))

;;; ----------------------------------------------------------------------------------------- names

;;; Names of sine and cosine of an angle (first coefficient positive): q1 -> [sq1, cq1], q2+q3 ->
;;; [sq23, cq23], q1-q2 -> [sq1m2, cq1m2], 2*q1 -> [s2q1, c2q1], theta+phi -> [stheta_phi,
;;; cphi_theta], q9+q10 -> [sq9_10, cq9_10], q1+...+q12 -> [sq1to12, cq1to12]. Two angles of one
;;; scene may still collide (q1+q2 with a coordinate q12): gs__atoms settles that by sq1_q2.
(defun $gs__trig_names (angle) (gs-names-of-text (gs-angle-text (cdr angle))))
(defun gs-names-of-text (text)
  (let ((before (if (member text *gs-ends-of-intrinsics* :test #'string=) "_" ""))
        (short (if (> (length text) 24)
                   (gs-text (subseq text 0 15) "_" (format nil "~d" ($gs__text_number text)))
                   text)))
    (gs-list (list ($concat '$s before short) ($concat '$c before short)))))
;;; s or c before these would be a function of Fortran (a coordinate named os: cos)
(defvar *gs-ends-of-intrinsics*
  '("in" "os" "inh" "osh" "qrt" "ign" "ize" "um" "har" "mplx" "onjg" "ount" "hift" "can"
    "et_exponent" "pread" "elected_int_kind" "cale" "pacing" "eiling"))
;;; a number of at most six digits that depends on every character of a text
(defun $gs__text_number (text)
  (let ((h 7)) (loop for c across text do (setq h (mod (+ (* 31 h) (char-code c)) 999983))) h))

;;; names of an angle of which `used` (of a text in lower case) says no
(defun $gs__free_names_by (angle used)
  (let ((try ($gs__trig_names angle)) (k 0))
    (flet ((used-p (s)
             (definitely-so (mapply1 used (list (string-downcase ($sconcat s))) used nil))))
      (loop while (some #'used-p (cdr try))
            do (setq try (gs-names-of-text
                           (gs-text (gs-angle-listed (cdr angle))
                                    (if (zerop k) "" (format nil "_~d" k)))))
               (incf k))
      try)))

;;; what follows the s or c: "q1", "q23", "theta_phi", "q1m2", "2q1"
(defun gs-angle-text (terms)
  (let* ((parts (mapcar #'(lambda (x) (gs-split-name ($sconcat (cadr x)))) terms))
         (heads (mapcar #'car parts)) (tails (mapcar #'cdr parts)) (factors (mapcar #'caddr terms)))
    (cond ((or (cdr (remove-duplicates heads :test #'string=)) (member "" tails :test #'string=))
           (gs-angle-listed terms))
          ((gs-run-p factors (mapcar #'parse-integer tails))
           (gs-text (car heads) (car tails) "to" (car (last tails))))
          (t (gs-angle-joined factors (car heads) tails)))))
;;; q12 -> ("q" . "12"), theta -> ("theta" . "")
(defun gs-split-name (text)
  (let ((k (or (position-if-not #'digit-char-p text :from-end t :start 1) 0)))
    (cons (subseq text 0 (1+ k)) (subseq text (1+ k)))))
;;; consecutive numbers, all with coefficient 1, that are too many to be joined
(defun gs-run-p (factors numbers)
  (and (> (length numbers) 3)
       (every #'(lambda (n) (eql n 1)) factors)
       (loop for (a b) on numbers always (or (null b) (= b (1+ a))))
       (or (> (length numbers) 6) (> (car (last numbers)) 9))))
;;; a coefficient inside a name: 1 is silent, -1 is m, 2 is p2_ (2 when it comes first), -2 is m2_
(defun gs-factor-in-name (n leads)
  (cond ((eql n 1) "")
        ((eql n -1) "m")
        (leads (format nil "~d" n))
        (t (format nil "~a~d_" (if (minusp n) "m" "p") (abs n)))))
(defun gs-angle-joined (factors head tails)
  (let ((gap (if (some #'(lambda (x) (> (length x) 1)) tails) "_" "")))
    (flet ((joined (n tail) (gs-text (if (eql n 1) gap "") (gs-factor-in-name n nil) tail)))
      (gs-text (gs-factor-in-name (car factors) t) head (car tails)
               (gs-joined (mapcar #'joined (cdr factors) (cdr tails)) "")))))
(defun gs-angle-listed (terms)
  (let ((first (car terms)))
    (flet ((listed (x) (gs-text (gs-factor-in-name (caddr x) (eq x first)) ($sconcat (cadr x)))))
      (gs-joined (mapcar #'listed terms) "_"))))

;;; ---------------------------------------------------------------------------------------- values

;;; [sine, cosine] of a sum of n_i*angle_i from [[sine_i, cosine_i], n_i]
(defun $gs__added (l)
  (let ((s 0) (c 1))
    (loop for (nil (nil si ci) n) in (cdr l)
          do (let ((si (if (minusp n) (mul -1 si) si)))
               (dotimes (k (abs n))
                 (psetq s (add (mul s ci) (mul c si)) c (sub (mul c ci) (mul s si))))))
    (gs-list (list s c))))
;;; a rational of one or two digits, different for neighbouring k and i, never 0, 1 or -1
(defun $gs__small_rational (k i)
  (multiple-value-bind (q h) (floor (mod (+ (* 7919 k) (* 104729 i) (* 31 k i) 12345) 99991) 17)
    (let ((p (+ 2 h)))
      (div (if (evenp q) p (- p)) (+ p 1 (mod (floor q 2) 11))))))
