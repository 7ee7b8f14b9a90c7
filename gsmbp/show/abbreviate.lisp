;;; show/abbreviate.lisp: values of tape code at many states at once, what every term of its sums
;;; does to the efforts, and bounds by intervals. An entry is [name, expression, block, number,
;;; symbols]. A vector holds a number for every state; what does not change is one number.
(in-package :maxima)

(defvar *gsi-entries* nil)              ; name -> entry, to find the products of a sum
(defvar *gsi-trig* nil)                 ; name -> [partner, angle, sin or cos]

;;; ---------------------------------------------------------------------------------------- vectors

(defun gsv-vector (n x) (make-array n :element-type 'double-float :initial-element x))
(defmacro gsv-loop (v n form)
  `(let ((,v (gsv-vector ,n 0d0))) (dotimes (k ,n ,v) (setf (aref ,v k) ,form))))

(defun gsv-plus (a b)
  (cond ((and (numberp a) (numberp b)) (+ a b))
        ((numberp a) (gsv-plus b a))
        ((numberp b) (if (zerop b) a (gsv-loop v (length a) (+ (aref a k) b))))
        (t (gsv-loop v (length a) (+ (aref a k) (aref b k))))))
(defun gsv-times (a b)
  (cond ((and (numberp a) (numberp b)) (* a b))
        ((numberp a) (gsv-times b a))
        ((numberp b)
         (cond ((zerop b) 0d0) ((= b 1) a) (t (gsv-loop v (length a) (* (aref a k) b)))))
        (t (gsv-loop v (length a) (* (aref a k) (aref b k))))))
(defun gsv-map (f a) (if (numberp a) (funcall f a) (gsv-loop v (length a) (funcall f (aref a k)))))
(defun gsv-largest (a)
  (if (numberp a)
      (abs a)
      (let ((m 0d0)) (dotimes (k (length a) m) (setq m (max m (abs (aref a k))))))))
(defun gsv-power (a n)
  (if (integerp n)
      (gsv-map #'(lambda (x) (expt x n)) a)
      (gsv-map #'(lambda (x) (expt x (coerce n 'double-float))) a)))

(defun gsv-number (e)
  (coerce (let ((x ($float e))) (if (numberp x) x (merror "gsmbp_abbreviate: no number for ~M" e)))
          'double-float))
;;; functions of one argument: (value . derivative)
(defun gsv-function (op)
  (case op
    (%sin (cons #'sin #'cos))
    (%cos (cons #'cos #'(lambda (x) (- (sin x)))))
    (%tan (cons #'tan #'(lambda (x) (/ 1 (expt (cos x) 2)))))
    (%tanh (cons #'tanh #'(lambda (x) (- 1 (expt (tanh x) 2)))))
    (%atan (cons #'atan #'(lambda (x) (/ 1 (+ 1 (* x x))))))
    (%exp (cons #'exp #'exp))
    (mabs (cons #'abs #'signum))
    (%signum (cons #'signum #'(lambda (x) (* 0 x))))
    (t (merror "gsmbp_abbreviate: ~M cannot be bounded" op))))

(defun gsv-exponent (e)
  (let ((n (caddr e)))
    (cond ((integerp n) n)
          ((mnump n) (/ (cadr n) (caddr n)))
          (t (merror "gsmbp_abbreviate: power ~M cannot be bounded" e)))))

;;; value of an expression by the values in the table h
(defun gsv-value (h e)
  (cond ((numberp e) (coerce e 'double-float))
        ((symbolp e) (or (gethash e h) (gsv-number e)))
        ((mnump e) (gsv-number e))
        (t (case (caar e)
             (mplus (let ((s 0d0)) (dolist (x (cdr e) s) (setq s (gsv-plus s (gsv-value h x))))))
             (mtimes (let ((s 1d0)) (dolist (x (cdr e) s) (setq s (gsv-times s (gsv-value h x))))))
             (mexpt (gsv-power (gsv-value h (cadr e)) (gsv-exponent e)))
             (t (let ((a (mapcar #'(lambda (x) (gsv-value h x)) (cdr e))))
                  (if (every #'numberp a)
                      (gsv-number (simplifya (cons (list (caar e)) a) nil))
                      (gsv-map (car (gsv-function (caar e))) (car a)))))))))

;;; the values of code, into the table
(defun $gsmbp__sample_values (h code)
  (dolist (x (cdr code) h)
    (unless (gethash (gsmbp-entry-name x) h)
      (setf (gethash (gsmbp-entry-name x) h) (gsv-value h (gsmbp-entry-expression x))))))

;;; n numbers between lo and hi, by chance (always the same for one seed); corner: the ends instead,
;;; for every second state
(defun $gsmbp__sample_range (seed n lo hi corner)
  (let ((s (mod (+ 12345 (* 7919 seed)) 2147483647)) (lo (gsv-number lo)) (hi (gsv-number hi)))
    (dotimes (i 5) (setq s (mod (* 16807 s) 2147483647)))
    (gsv-loop v n (let ((x (/ (setq s (mod (* 16807 s) 2147483647)) 2147483647d0)))
                    (if (and corner (oddp k)) (if (< x 0.5d0) lo hi) (+ lo (* x (- hi lo))))))))

;;; vectors of norm 1 in place: Euler parameters
(defun $gsmbp__sample_sphere (vectors)
  (let ((l (cdr vectors)))
    (dotimes (k (length (car l)))
      (let ((n (sqrt (reduce #'+ (mapcar #'(lambda (v) (expt (aref v k) 2)) l)))))
        (dolist (v l) (setf (aref v k) (/ (aref v k) n)))))))

;;; The rows: sums of weight * output. weights: by row, by output a number or a value of the table;
;;; result: by row the vector.
(defun gsv-weight (h w) (if (numberp w) (coerce w 'double-float) (gsv-value h w)))
(defun $gsmbp__sample_rows (h outputs weights n)
  (cons '(mlist)
        (mapcar #'(lambda (row)
                    (let ((s (gsv-vector n 0d0)))
                      (mapc #'(lambda (e w)
                                (unless (eql w 0)
                                  (setq s
                                        (gsv-plus s (gsv-times (gsv-weight h w) (gsv-value h e))))))
                            (cdr outputs) (cdr row))
                      s)) (cdr weights))))
(defun $gsmbp__sample_largest (rows) (cons '(mlist) (mapcar #'gsv-largest (cdr rows))))
(defun $gsmbp__sample_apart (a b)
  (cons '(mlist) (mapcar #'(lambda (x y) (gsv-plus x (gsv-times -1d0 y))) (cdr a) (cdr b))))
(defun $gsmbp__sample_copy (h)
  (let ((c (make-hash-table :test #'eq))) (maphash #'(lambda (s v) (setf (gethash s c) v)) h) c))

;;; ---------------------------------------------------------------------------------- what terms do

;;; adds w to the adjoint of the symbols of an expression
(defun gsv-spread (h bars e w)
  (cond ((symbolp e)
         (when (nth-value 1 (gethash e bars))
           (setf (gethash e bars) (gsv-plus (gethash e bars) w))))
        ((or (numberp e) (mnump e)) nil)
        (t (case (caar e)
             (mplus (dolist (x (cdr e)) (gsv-spread h bars x w)))
             (mtimes (dolist (x (cdr e))
                       (unless (or (numberp x) (mnump x))
                         (let ((s w))
                           (dolist (y (cdr e))
                             (unless (eq x y) (setq s (gsv-times s (gsv-value h y)))))
                           (gsv-spread h bars x s)))))
             (mexpt (let ((n (gsv-exponent e)) (x (gsv-value h (cadr e))))
                      (gsv-spread
                        h bars (cadr e)
                        (gsv-times w (gsv-times (coerce n 'double-float) (gsv-power x (1- n)))))))
             (t (gsv-spread
                  h bars (cadr e)
                  (gsv-times w (gsv-map (cdr (gsv-function (caar e))) (gsv-value h (cadr e))))))))))

;;; adjoints of one row: a table name -> vector, for the entries that are not fixed (sines and
;;; cosines, angles)
(defun gsv-adjoint (h code outputs row fixed)
  (let ((bars (make-hash-table :test #'eq)))
    (dolist (x code)
      (unless (gethash (gsmbp-entry-name x) fixed) (setf (gethash (gsmbp-entry-name x) bars) 0d0)))
    (mapc #'(lambda (e w) (unless (eql w 0) (gsv-spread h bars e (gsv-weight h w)))) outputs row)
    (dolist (x (reverse code) bars)
      (let ((w (gethash (gsmbp-entry-name x) bars)))
        (unless (or (null w) (and (numberp w) (zerop w)))
          (gsv-spread h bars (gsmbp-entry-expression x) w))))))

;;; operations that go with the term e of a sum: those of names used nowhere else
(defun gsv-gain (e uses entries)
  (let ((n 1))
    (labels ((take (x)
               (cond ((symbolp x)
                      (let ((y (gethash x entries)))
                        (when (and y (eql (gethash x uses) 1)) (take (gsmbp-entry-expression y)))))
                     ((or (numberp x) (mnump x)) nil)
                     (t (incf n (length (cddr x))) (mapc #'take (cdr x))))))
      (take e)
      n)))

;;; Which terms of the sums can go. errors: by row the vector of errors so far; limits: by row the
;;; largest allowed; room: by row what the bounds may add up to. Result: [[name, term, largest
;;; effect over the limits], ...], those that gain most for their effect first.
(defun $gsmbp__terms_to_drop (tp h code outputs weights ranges errors limits room fixed)
  (let* ((x (gsi-table h ranges)) (*gsi-entries* (gsmbp-entries tp)) (*gsi-trig* (nth 6 tp))
         (code (cdr code)) (outputs (cdr outputs)) (rows (mapcar #'cdr (cdr weights)))
         (limits (cdr limits)) (room (copy-list (cdr room)))
         (errors (mapcar #'copy-seq (cdr errors))) (chosen nil) bars slopes)
    (gsi-along x (make-hash-table :test #'eq) code nil)
    (setq bars (mapcar #'(lambda (row) (gsv-adjoint h code outputs row fixed)) rows)
          slopes (mapcar #'(lambda (row) (gsi-adjoint x code outputs row fixed)) rows))
    (dolist (i (gsv-candidates h code outputs bars limits fixed) (cons '(mlist) (nreverse chosen)))
      (let* ((v (gsv-value h (caddr i))) (size (gsi-size (gsi-value x nil (caddr i))))
             (after (mapcar #'(lambda (b e)
                                (gsv-plus e (gsv-times -1d0 (gsv-times v (gethash (cadr i) b)))))
                            bars errors))
             (left (mapcar #'(lambda (b r) (- r (* size (gethash (cadr i) b 0d0)))) slopes room)))
        (when (and (notany #'minusp left)
                   (every #'(lambda (e limit) (<= (gsv-largest e) limit)) after limits))
          (setq errors after room left)
          (push (list '(mlist) (cadr i) (caddr i) (cadddr i)) chosen))))))

;;; Terms whose effect is within the limits, as (effect by gain, name, term, effect over the
;;; limits), in this order.
(defun gsv-candidates (h code outputs bars limits fixed)
  (let ((uses (make-hash-table :test #'eq)) (entries (make-hash-table :test #'eq)) (items nil))
    (dolist (x code)
      (setf (gethash (gsmbp-entry-name x) entries) x)
      (dolist (s (gsmbp-entry-symbols x)) (incf (gethash s uses 0))))
    (dolist (e outputs) (dolist (s (cdr ($gsmbp__symbols e))) (incf (gethash s uses 0) 2)))
    (dolist (x code (sort items #'< :key #'car))
      (when (and (gsmbp-sum-p (gsmbp-entry-expression x))
                 (not (gethash (gsmbp-entry-name x) fixed)))
        (dolist (e (cdr (gsmbp-entry-expression x)))
          (let ((worst 0d0) (v (gsv-value h e)))
            (mapc #'(lambda (b limit)
                      (setq worst
                            (max worst
                                 (/ (gsv-largest (gsv-times v (gethash (gsmbp-entry-name x) b)))
                                    limit)))) bars limits)
            (when (< worst 1)
              (push (list (/ worst (gsv-gain e uses entries)) (gsmbp-entry-name x) e worst)
                    items))))))))

;;; -------------------------------------------------------------------------------------- intervals

;;; An interval is (lo . hi). What has no bound (1/x where x may be 0) is held at 1e100, so that
;;; sizes can be multiplied.
(defconstant gsi-most 1d100)
(defun gsi-clip (x) (max (- gsi-most) (min gsi-most x)))
(defun gsi-size (x) (max (abs (car x)) (abs (cdr x))))
(defun gsi-plus (a b) (cons (gsi-clip (+ (car a) (car b))) (gsi-clip (+ (cdr a) (cdr b)))))
(defun gsi-times (a b)
  (let ((p (list (* (car a) (car b)) (* (car a) (cdr b)) (* (cdr a) (car b)) (* (cdr a) (cdr b)))))
    (cons (gsi-clip (reduce #'min p)) (gsi-clip (reduce #'max p)))))
;;; a to the power n; a root is taken of what is not below 0
(defun gsi-power (a n)
  (let ((lo (car a)) (hi (cdr a)))
    (flet ((power (x)
             (gsi-clip (if (> (abs x) 1d50) (* (if (oddp n) (signum x) 1) gsi-most) (expt x n)))))
      (cond ((not (integerp n)) (gsi-root (max lo 0d0) (max hi 0d0) (coerce n 'double-float)))
            ((minusp n)
             (if (<= lo 0 hi)
                 (cons (if (evenp n) 0d0 (- gsi-most)) gsi-most)
                 (gsi-power (cons (/ 1 hi) (/ 1 lo)) (- n))))
            ((oddp n) (cons (power lo) (power hi)))
            (t (cons (if (<= lo 0 hi) 0d0 (min (power lo) (power hi)))
                     (max (power lo) (power hi))))))))
(defun gsi-root (lo hi n)
  (flet ((root (x) (if (zerop x) (if (plusp n) 0d0 gsi-most) (gsi-clip (expt (min x 1d60) n)))))
    (cons (min (root lo) (root hi)) (max (root lo) (root hi)))))
(defun gsi-function (op a e)
  (let ((lo (car a)) (hi (cdr a)))
    (case op
      (%sin (gsi-sine lo hi))
      (%cos (gsi-sine (+ lo (/ pi 2)) (+ hi (/ pi 2))))
      (mabs (cons (if (<= lo 0 hi) 0d0 (min (abs lo) (abs hi))) (gsi-size a)))
      ((%tanh %atan %exp %signum)
       (let ((f (car (gsv-function op)))) (cons (funcall f lo) (funcall f hi))))
      (t (merror "gsmbp_abbreviate: ~M has no bound over these ranges" e)))))
(defun gsi-sine (lo hi)
  (let ((lo (coerce lo 'double-float)) (hi (coerce hi 'double-float)))
    (flet ((holds (top) (let ((k (ceiling (/ (- lo top) (* 2 pi))))) (<= (+ top (* 2 pi k)) hi))))
      (cons (if (holds (/ pi -2)) -1d0 (min (sin lo) (sin hi)))
            (if (holds (/ pi 2)) 1d0 (max (sin lo) (sin hi)))))))
;;; largest |derivative| of a function over an interval
(defun gsi-slope (op a e)
  (case op
    ((%sin %cos %tanh %atan mabs) 1d0)
    (%exp (exp (cdr a)))
    (t (merror "gsmbp_abbreviate: ~M has no bound over these ranges" e))))

;;; Interval and error bound of an expression, two values, by tables x (intervals) and r (errors).
(defun gsi-value (x r e)
  (cond ((numberp e) (let ((v (coerce e 'double-float))) (values (cons v v) 0d0)))
        ((and (symbolp e) (gethash e x)) (values (gethash e x) (if r (gethash e r 0d0) 0d0)))
        ((or (symbolp e) (mnump e)) (let ((v (gsv-number e))) (values (cons v v) 0d0)))
        (t (case (caar e)
             (mplus (gsi-sum x r (cdr e)))
             (mtimes (let ((a (cons 1d0 1d0)) (d 0d0))
                       (dolist (y (cdr e) (values a d))
                         (multiple-value-bind (b f) (gsi-value x r y)
                           (setq d (gsi-clip (+ (* (gsi-size a) f) (* (gsi-size b) d) (* d f)))
                                 a (gsi-times a b))))))
             (mexpt (multiple-value-bind (a d) (gsi-value x r (cadr e))
                      (let* ((n (gsv-exponent e)) (wide (cons (- (car a) d) (+ (cdr a) d))))
                        (values (gsi-power a n)
                                (if (zerop d)
                                    0d0
                                    (gsi-clip (* d
                                                 (abs (coerce n 'double-float))
                                                 (if (eql n 2)
                                                     (gsi-size wide)
                                                     (gsi-size (gsi-power wide (1- n)))))))))))
             (t (multiple-value-bind (a d) (gsi-value x r (cadr e))
                  (values (gsi-function (caar e) a e)
                          (if (zerop d)
                              0d0
                              (* d
                                 (gsi-slope (caar e) (cons (- (car a) d) (+ (cdr a) d)) e))))))))))

;;; A sum. Two products with the sine and the cosine of one angle are together at most the length of
;;; the vector that they turn.
(defun gsi-sum (x r terms)
  (let ((a (cons 0d0 0d0)) (d 0d0) (turned nil))
    (dolist (y terms)
      (multiple-value-bind (b f) (gsi-value x r y)
        (let* ((p (gsi-turned y)) (other (and p (assoc (car p) turned :test #'equal))))
          (cond ((null p) (setq a (gsi-plus a b) d (gsi-clip (+ d f))))
                (other (setq turned (remove other turned :test #'eq))
                       (multiple-value-bind (u du) (gsi-value x r (cdr p))
                         (multiple-value-bind (w dw) (gsi-value x r (cadr other))
                           (let ((length_ (sqrt (+ (expt (gsi-size u) 2) (expt (gsi-size w) 2))))
                                 (s (gsi-plus b (caddr other))))
                             (setq a (gsi-plus a
                                               (cons (max (car s) (- length_))
                                                     (min (cdr s) length_)))
                                   d (+ d
                                        (min (+ f (cadddr other))
                                             (sqrt (+ (expt du 2) (expt dw 2))))))))))
                (t (push (list (gsi-partner (car p)) (cdr p) b f) turned))))))
    (dolist (y turned (values a d)) (setq a (gsi-plus a (caddr y)) d (+ d (cadddr y))))))

;;; (sine or cosine . the rest) of a term that is a name (or its opposite) of such a product, nil
;;; else
(defun gsi-turned (e)
  (let* ((s (cond ((symbolp e) e)
                  ((and (gsmbp-product-p e) (eql (cadr e) -1) (symbolp (caddr e)) (null (cdddr e)))
                   (caddr e))))
         (p (if s (let ((y (gethash s *gsi-entries*))) (and y (gsmbp-entry-expression y))) e)))
    (when (and (gsmbp-product-p p) (= (length p) 3) (symbolp (cadr p)) (symbolp (caddr p)))
      (cond ((gethash (cadr p) *gsi-trig*) (cons (cadr p) (caddr p)))
            ((gethash (caddr p) *gsi-trig*) (cons (caddr p) (cadr p)))))))
(defun gsi-partner (s) (cadr (gethash s *gsi-trig*)))

;;; the intervals of what has a range, and of the constants in the table h
(defun gsi-table (h ranges)
  (let ((x (make-hash-table :test #'eq)))
    (maphash #'(lambda (s v) (when (numberp v) (setf (gethash s x) (cons v v)))) h)
    (dolist (e (cdr ranges) x)
      (setf (gethash (cadr e) x)
            (cons (gsv-number (cadr (caddr e))) (gsv-number (caddr (caddr e))))))))

;;; Intervals of code into the table x, bounds of the errors into r; gone: table name -> terms that
;;; are dropped there, or nil.
(defun gsi-along (x r code gone)
  (dolist (e code)
    (multiple-value-bind (a d) (gsi-value x r (gsmbp-entry-expression e))
      (let ((lost (and gone (gethash (gsmbp-entry-name e) gone))))
        (when lost
          (let ((left (remove-if
                        #'(lambda (y) (member y lost :test #'equal))
                        (cdr (gsmbp-entry-expression e)))))
            (setq d (+ (nth-value 1 (gsi-sum x r left)) (gsi-size (gsi-sum x nil lost)))))))
      (setf (gethash (gsmbp-entry-name e) x) a)
      (unless (zerop d) (setf (gethash (gsmbp-entry-name e) r) d)))))

;;; bounds of the derivatives of one row by the entries: name -> number
(defun gsi-adjoint (x code outputs row fixed)
  (let ((b (make-hash-table :test #'eq)))
    (mapc #'(lambda (e w)
              (unless (eql w 0) (gsi-spread x b e (gsi-size (gsi-value x nil w)) fixed))) outputs
          row)
    (dolist (e (reverse code) b)
      (let ((w (gethash (gsmbp-entry-name e) b)))
        (when w (gsi-spread x b (gsmbp-entry-expression e) w fixed))))))
(defun gsi-spread (x b e w fixed)
  (cond ((symbolp e)
         (unless (gethash e fixed) (setf (gethash e b) (gsi-clip (+ w (gethash e b 0d0))))))
        ((or (numberp e) (mnump e)) nil)
        (t (case (caar e)
             (mplus (dolist (y (cdr e)) (gsi-spread x b y w fixed)))
             (mtimes (dolist (y (cdr e))
                       (unless (or (numberp y) (mnump y))
                         (let ((s w))
                           (dolist (z (cdr e))
                             (unless (eq y z)
                               (setq s (gsi-clip (* s (gsi-size (gsi-value x nil z)))))))
                           (gsi-spread x b y s fixed)))))
             (mexpt (let ((n (gsv-exponent e)) (a (gsi-value x nil (cadr e))))
                      (gsi-spread
                        x b (cadr e)
                        (gsi-clip (* w
                                     (abs (coerce n 'double-float))
                                     (if (eql n 2) (gsi-size a) (gsi-size (gsi-power a (1- n))))))
                        fixed)))
             (t (gsi-spread
                  x b (cadr e) (* w (gsi-slope (caar e) (gsi-value x nil (cadr e)) e)) fixed))))))

;;; Bounds by row of what dropping terms ([name, term, ..], ...) from the sums of code changes:
;;; ranges: [symbol = [lo, hi], ...]; h: the constants.
(defun $gsmbp__dropped_bounds (tp h code outputs weights dropped ranges)
  (let ((x (gsi-table h ranges)) (r (make-hash-table :test #'eq))
        (gone (make-hash-table :test #'eq)) (*gsi-entries* (gsmbp-entries tp))
        (*gsi-trig* (nth 6 tp)))
    (dolist (d (cdr dropped)) (push (caddr d) (gethash (cadr d) gone)))
    (gsi-along x r (cdr code) gone)
    (cons '(mlist)
          (mapcar #'(lambda (row)
                      (let ((s 0d0))
                        (mapc #'(lambda (e w)
                                  (unless (eql w 0)
                                    (setq s
                                          (+ s
                                             (* (gsi-size (gsi-value x r w))
                                                (nth-value 1 (gsi-value x r e))))))) (cdr outputs)
                              (cdr row))
                        s)) (cdr weights)))))

;;; --------------------------------------------------------------------------------------- definite

;;; Of n states: how many have a matrix (rows of expressions) that is not positive definite, by
;;; Cholesky's elimination.
(defun $gsmbp__sample_indefinite (h rows n)
  (let ((bad 0)
        (v (mapcar #'(lambda (r) (mapcar #'(lambda (e) (gsv-value h e)) (cdr r))) (cdr rows)))
        (m (length (cdr rows))))
    (dotimes (k n bad)
      (let ((a (make-array (list m m))) (good t) (i 0))
        (dolist (r v)
          (let ((j 0)) (dolist (e r) (setf (aref a i j) (if (numberp e) e (aref e k))) (incf j)))
          (incf i))
        (dotimes (p m)
          (if (> (aref a p p) 0)
              (do ((i (1+ p) (1+ i)))
                  ((>= i m))
                (let ((f (/ (aref a i p) (aref a p p))))
                  (do ((j (1+ p) (1+ j))) ((>= j m)) (decf (aref a i j) (* f (aref a p j))))))
              (progn (setq good nil) (return))))
        (unless good (incf bad))))))
