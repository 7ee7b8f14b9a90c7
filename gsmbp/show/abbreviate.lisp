;;; show/abbreviate.lisp: values of tape code at many states at once, what every term of its sums
;;; does to the efforts, and bounds by intervals. An entry is [name, expression, block, number,
;;; symbols]. A vector holds a number for every state; what does not change is one number.
(in-package :maxima)

(defvar *gs-entries* nil)              ; name -> entry, to find the products of a sum
(defvar *gs-trig* nil)                 ; name -> [partner, angle, sin or cos]

;;; ---------------------------------------------------------------------------------------- vectors

(defun gs-vector (n x) (make-array n :element-type 'double-float :initial-element x))
(defmacro gs-loop (v n form)
  `(let ((,v (gs-vector ,n 0d0))) (dotimes (k ,n ,v) (setf (aref ,v k) ,form))))

(defun gs-val-plus (a b)
  (cond ((and (numberp a) (numberp b)) (+ a b))
        ((numberp a) (gs-val-plus b a))
        ((numberp b) (if (zerop b) a (gs-loop v (length a) (+ (aref a k) b))))
        (t (gs-loop v (length a) (+ (aref a k) (aref b k))))))
(defun gs-val-times (a b)
  (cond ((and (numberp a) (numberp b)) (* a b))
        ((numberp a) (gs-val-times b a))
        ((numberp b)
         (cond ((zerop b) 0d0) ((= b 1) a) (t (gs-loop v (length a) (* (aref a k) b)))))
        (t (gs-loop v (length a) (* (aref a k) (aref b k))))))
(defun gs-map (f a) (if (numberp a) (funcall f a) (gs-loop v (length a) (funcall f (aref a k)))))
(defun gs-val-largest (a)
  (if (numberp a)
      (abs a)
      (let ((m 0d0)) (dotimes (k (length a) m) (setq m (max m (abs (aref a k))))))))
(defun gs-val-power (a n)
  (if (integerp n)
      (gs-map #'(lambda (x) (expt x n)) a)
      (gs-map #'(lambda (x) (expt x (coerce n 'double-float))) a)))

(defun gs-val-number (e)
  (coerce (let ((x ($float e))) (if (numberp x) x (gs-abbreviate-stops "no number for " e)))
          'double-float))
;;; that of GCL overflows
(defun gs-tanh (x)
  (let ((e (exp (* -2 (abs x)))))
    (* (cl:signum x) (/ (- 1 e) (+ 1 e)))))
;;; functions of one argument: (value . derivative). In the package of Maxima the name tan has no
;;; function, and signum of a double is an integer there.
(defun gs-val-function (op)
  (case op
    (%sin (cons #'sin #'cos))
    (%cos (cons #'cos #'(lambda (x) (- (sin x)))))
    (%tan (cons #'cl:tan #'(lambda (x) (/ 1 (expt (cos x) 2)))))
    (%tanh (cons #'gs-tanh #'(lambda (x) (- 1 (expt (gs-tanh x) 2)))))
    (%atan (cons #'atan #'(lambda (x) (/ 1 (+ 1 (* x x))))))
    (%exp (cons #'exp #'exp))
    (mabs (cons #'abs #'cl:signum))
    (%signum (cons #'cl:signum #'(lambda (x) (* 0 x))))
    (t (gs-abbreviate-stops op " cannot be bounded"))))

(defun gs-exponent (e)
  (let ((n (caddr e)))
    (cond ((integerp n) n)
          ((mnump n) (/ (cadr n) (caddr n)))
          (t (mfuncall '$gs__error "gsmbp_abbreviate"
                       "terms with this power cannot be bounded (friction of a device has it): "
                       e)))))

;;; value of an expression by the values in the table h
(defun gs-val-value (h e)
  (cond ((numberp e) (coerce e 'double-float))
        ((symbolp e) (or (gethash e h) (gs-val-number e)))
        ((mnump e) (gs-val-number e))
        (t (case (caar e)
             (mplus (let ((s 0d0))
                         (dolist (x (cdr e) s) (setq s (gs-val-plus s (gs-val-value h x))))))
             (mtimes (let ((s 1d0))
                          (dolist (x (cdr e) s) (setq s (gs-val-times s (gs-val-value h x))))))
             (mexpt (gs-val-power (gs-val-value h (cadr e)) (gs-exponent e)))
             (t (let ((a (mapcar #'(lambda (x) (gs-val-value h x)) (cdr e))))
                  (if (every #'numberp a)
                      (gs-val-number (simplifya (cons (list (caar e)) a) nil))
                      (gs-map (car (gs-val-function (caar e))) (car a)))))))))

;;; the values of code, into the table
(defun $gs__sample_values (h code)
  (dolist (x (cdr code) h)
    (unless (gethash (gs-entry-name x) h)
      (setf (gethash (gs-entry-name x) h) (gs-val-value h (gs-entry-expression x))))))

;;; n numbers between lo and hi, by chance (always the same for one seed); corner: the ends instead,
;;; for every second state
(defun $gs__sample_range (seed n lo hi corner)
  (let ((s (mod (+ 12345 (* 7919 seed)) 2147483647)) (lo (gs-val-number lo))
        (hi (gs-val-number hi)))
    (dotimes (i 5) (setq s (mod (* 16807 s) 2147483647)))
    (gs-loop v n (let ((x (/ (setq s (mod (* 16807 s) 2147483647)) 2147483647d0)))
                   (if (and corner (oddp k)) (if (< x 0.5d0) lo hi) (+ lo (* x (- hi lo))))))))

;;; vectors of norm 1 in place: Euler parameters
(defun $gs__sample_sphere (vectors)
  (let ((l (cdr vectors)))
    (dotimes (k (length (car l)))
      (let ((n (sqrt (reduce #'+ (mapcar #'(lambda (v) (expt (aref v k) 2)) l)))))
        (dolist (v l) (setf (aref v k) (/ (aref v k) n)))))))

;;; The rows: sums of weight * output. weights: by row, by output a number or a value of the table;
;;; result: by row the vector.
(defun gs-weight (h w) (if (numberp w) (coerce w 'double-float) (gs-val-value h w)))
(defun $gs__sample_rows (h outputs weights n)
  (cons '(mlist)
        (mapcar #'(lambda (row)
                    (let ((s (gs-vector n 0d0)))
                      (mapc #'(lambda (e w)
                                (unless (eql w 0)
                                  (setq s
                                        (gs-val-plus s (gs-val-times (gs-weight h w)
                                                                     (gs-val-value h e))))))
                            (cdr outputs) (cdr row))
                      s)) (cdr weights))))
(defun $gs__sample_largest (rows) (cons '(mlist) (mapcar #'gs-val-largest (cdr rows))))
(defun $gs__sample_apart (a b)
  (cons '(mlist) (mapcar #'(lambda (x y) (gs-val-plus x (gs-val-times -1d0 y))) (cdr a) (cdr b))))
(defun $gs__sample_copy (h)
  (let ((c (make-hash-table :test #'eq))) (maphash #'(lambda (s v) (setf (gethash s c) v)) h) c))

;;; ---------------------------------------------------------------------------------- what terms do

;;; adds w to the adjoint of the symbols of an expression
(defun gs-val-spread (h bars e w)
  (cond ((symbolp e)
         (when (nth-value 1 (gethash e bars))
           (setf (gethash e bars) (gs-val-plus (gethash e bars) w))))
        ((or (numberp e) (mnump e)) nil)
        (t (case (caar e)
             (mplus (dolist (x (cdr e)) (gs-val-spread h bars x w)))
             (mtimes (dolist (x (cdr e))
                       (unless (or (numberp x) (mnump x))
                         (let ((s w))
                           (dolist (y (cdr e))
                             (unless (eq x y) (setq s (gs-val-times s (gs-val-value h y)))))
                           (gs-val-spread h bars x s)))))
             (mexpt (let ((n (gs-exponent e)) (x (gs-val-value h (cadr e))))
                      (gs-val-spread
                        h bars (cadr e)
                        (gs-val-times w (gs-val-times (coerce n 'double-float)
                                                      (gs-val-power x (1- n)))))))
             (t (gs-val-spread
                  h bars (cadr e)
                  (gs-val-times w (gs-map (cdr (gs-val-function (caar e)))
                                          (gs-val-value h (cadr e))))))))))

;;; adjoints of one row: a table name -> vector, for the entries that are not fixed (sines and
;;; cosines, angles)
(defun gs-val-adjoint (h code outputs row fixed)
  (let ((bars (make-hash-table :test #'eq)))
    (dolist (x code)
      (unless (gethash (gs-entry-name x) fixed) (setf (gethash (gs-entry-name x) bars) 0d0)))
    (mapc #'(lambda (e w) (unless (eql w 0) (gs-val-spread h bars e (gs-weight h w)))) outputs row)
    (dolist (x (reverse code) bars)
      (let ((w (gethash (gs-entry-name x) bars)))
        (unless (or (null w) (and (numberp w) (zerop w)))
          (gs-val-spread h bars (gs-entry-expression x) w))))))

;;; operations that go with the term e of a sum: those of names used nowhere else
(defun gs-gain (e uses entries)
  (let ((n 1))
    (gs-rec ((take (x)
               (cond ((symbolp x)
                      (let ((y (gethash x entries)))
                        (when (and y (eql (gethash x uses) 1)) (take (gs-entry-expression y)))))
                     ((or (numberp x) (mnump x)) nil)
                     (t (incf n (length (cddr x))) (mapc #'take (cdr x))))))
      (take e)
      n)))

;;; Which terms of the sums can go. errors: by row the vector of errors so far; limits: by row the
;;; largest allowed; room: by row what the bounds may add up to. Result: [[name, term, largest
;;; effect over the limits], ...], those that gain most for their effect first.
(defun $gs__terms_to_drop (tp h code outputs weights ranges errors limits room fixed)
  (let* ((x (gs-iv-table h ranges)) (*gs-entries* (gs-entries tp)) (*gs-trig* (nth 6 tp))
         (code (cdr code)) (outputs (cdr outputs)) (rows (mapcar #'cdr (cdr weights)))
         (limits (cdr limits)) (room (copy-list (cdr room)))
         (errors (mapcar #'copy-seq (cdr errors))) (chosen nil) bars slopes)
    (gs-along x (make-hash-table :test #'eq) code nil)
    (setq bars (mapcar #'(lambda (row) (gs-val-adjoint h code outputs row fixed)) rows)
          slopes (mapcar #'(lambda (row) (gs-iv-adjoint x code outputs row fixed)) rows))
    (dolist (i (gs-candidates h code outputs bars limits fixed) (cons '(mlist) (nreverse chosen)))
      (let* ((v (gs-val-value h (caddr i))) (size (gs-iv-size (gs-iv-value x nil (caddr i))))
             (after (mapcar #'(lambda (b e)
                                (gs-val-plus e (gs-val-times -1d0 (gs-val-times v (gethash (cadr i)
                                                                                           b)))))
                            bars errors))
             (left (mapcar #'(lambda (b r) (- r (* size (gethash (cadr i) b 0d0)))) slopes room)))
        (when (and (notany #'minusp left)
                   (every #'(lambda (e limit) (<= (gs-val-largest e) limit)) after limits))
          (setq errors after room left)
          (push (list '(mlist) (cadr i) (caddr i) (cadddr i)) chosen))))))

;;; Terms whose effect is within the limits, as (effect by gain, name, term, effect over the
;;; limits), in this order.
(defun gs-candidates (h code outputs bars limits fixed)
  (let ((uses (make-hash-table :test #'eq)) (entries (make-hash-table :test #'eq)) (items nil))
    (dolist (x code)
      (setf (gethash (gs-entry-name x) entries) x)
      (dolist (s (gs-entry-symbols x)) (incf (gethash s uses 0))))
    (dolist (e outputs) (dolist (s (cdr ($gs__symbols e))) (incf (gethash s uses 0) 2)))
    (dolist (x code (stable-sort items #'< :key #'car))
      (when (and (gs-sum-p (gs-entry-expression x))
                 (not (gethash (gs-entry-name x) fixed)))
        (dolist (e (cdr (gs-entry-expression x)))
          (let ((worst 0d0) (v (gs-val-value h e)))
            (mapc #'(lambda (b limit)
                      (setq worst
                            (max worst
                                 (/ (gs-val-largest (gs-val-times v (gethash (gs-entry-name x) b)))
                                    limit)))) bars limits)
            (when (< worst 1)
              (push (list (/ worst (gs-gain e uses entries)) (gs-entry-name x) e worst)
                    items))))))))

;;; -------------------------------------------------------------------------------------- intervals

;;; An interval is (lo . hi). What has no bound (1/x where x may be 0) is held at 1e100, so that
;;; sizes can be multiplied.
(defconstant gs-most 1d100)
(defun gs-clip (x) (max (- gs-most) (min gs-most x)))
(defun gs-iv-size (x) (max (abs (car x)) (abs (cdr x))))
(defun gs-iv-plus (a b) (cons (gs-clip (+ (car a) (car b))) (gs-clip (+ (cdr a) (cdr b)))))
(defun gs-iv-times (a b)
  (let ((p (list (* (car a) (car b)) (* (car a) (cdr b)) (* (cdr a) (car b)) (* (cdr a) (cdr b)))))
    (cons (gs-clip (reduce #'min p)) (gs-clip (reduce #'max p)))))
;;; a to the power n; a root is taken of what is not below 0
(defun gs-iv-power (a n)
  (let ((lo (car a)) (hi (cdr a)))
    (flet ((power (x)
             (gs-clip (if (> (abs x) 1d50) (* (if (oddp n) (signum x) 1) gs-most) (expt x n)))))
      (cond ((not (integerp n)) (gs-root (max lo 0d0) (max hi 0d0) (coerce n 'double-float)))
            ((minusp n)
             (if (<= lo 0 hi)
                 (cons (if (evenp n) 0d0 (- gs-most)) gs-most)
                 (gs-iv-power (cons (/ 1 hi) (/ 1 lo)) (- n))))
            ((oddp n) (cons (power lo) (power hi)))
            (t (cons (if (<= lo 0 hi) 0d0 (min (power lo) (power hi)))
                     (max (power lo) (power hi))))))))
(defun gs-root (lo hi n)
  (flet ((root (x) (if (zerop x) (if (plusp n) 0d0 gs-most) (gs-clip (expt (min x 1d60) n)))))
    (cons (min (root lo) (root hi)) (max (root lo) (root hi)))))
(defun gs-iv-function (op a e)
  (let ((lo (car a)) (hi (cdr a)))
    (case op
      (%sin (gs-sine lo hi))
      (%cos (gs-sine (+ lo (/ pi 2)) (+ hi (/ pi 2))))
      (%tan (gs-need-no-pole a e) (cons (cl:tan lo) (cl:tan hi)))
      (mabs (cons (if (<= lo 0 hi) 0d0 (min (abs lo) (abs hi))) (gs-iv-size a)))
      ((%tanh %atan %exp %signum)
       (let ((f (car (gs-val-function op)))) (cons (funcall f lo) (funcall f hi))))
      (t (gs-no-bound e)))))
(defun gs-no-bound (e) (gs-abbreviate-stops e " has no bound over these ranges"))
(defun gs-abbreviate-stops (&rest parts) (apply #'mfuncall '$gs__error "gsmbp_abbreviate" parts))
;;; e is a tangent over the interval a: no pole lies in it
(defun gs-need-no-pole (a e)
  (unless (= (floor (+ (car a) (/ pi 2)) pi) (floor (+ (cdr a) (/ pi 2)) pi)) (gs-no-bound e)))
(defun gs-sine (lo hi)
  (let ((lo (coerce lo 'double-float)) (hi (coerce hi 'double-float)))
    (flet ((holds (top) (let ((k (ceiling (/ (- lo top) (* 2 pi))))) (<= (+ top (* 2 pi k)) hi))))
      (cons (if (holds (/ pi -2)) -1d0 (min (sin lo) (sin hi)))
            (if (holds (/ pi 2)) 1d0 (max (sin lo) (sin hi)))))))
;;; largest |derivative| of a function over an interval
(defun gs-slope (op a e)
  (case op
    ((%sin %cos %tanh %atan mabs) 1d0)
    (%tan (gs-need-no-pole a e)
          (+ 1 (expt (max (abs (cl:tan (car a))) (abs (cl:tan (cdr a)))) 2)))
    (%exp (exp (cdr a)))
    (t (gs-no-bound e))))

;;; Interval and error bound of an expression, two values, by tables x (intervals) and r (errors).
(defun gs-iv-value (x r e)
  (cond ((numberp e) (let ((v (coerce e 'double-float))) (values (cons v v) 0d0)))
        ((and (symbolp e) (gethash e x)) (values (gethash e x) (if r (gethash e r 0d0) 0d0)))
        ((or (symbolp e) (mnump e)) (let ((v (gs-val-number e))) (values (cons v v) 0d0)))
        (t (case (caar e)
             (mplus (gs-iv-sum x r (cdr e)))
             (mtimes (let ((a (cons 1d0 1d0)) (d 0d0))
                       (dolist (y (cdr e) (values a d))
                         (multiple-value-bind (b f) (gs-iv-value x r y)
                           (setq d (gs-clip (+ (* (gs-iv-size a) f) (* (gs-iv-size b) d) (* d f)))
                                 a (gs-iv-times a b))))))
             (mexpt (multiple-value-bind (a d) (gs-iv-value x r (cadr e))
                      (let* ((n (gs-exponent e)) (wide (cons (- (car a) d) (+ (cdr a) d))))
                        (values (gs-iv-power a n)
                                (if (zerop d)
                                    0d0
                                    (gs-clip (* d
                                                (abs (coerce n 'double-float))
                                                (if (eql n 2)
                                                    (gs-iv-size wide)
                                                    (gs-iv-size (gs-iv-power wide (1- n)))))))))))
             (t (multiple-value-bind (a d) (gs-iv-value x r (cadr e))
                  (values (gs-iv-function (caar e) a e)
                          (if (zerop d)
                              0d0
                              (* d
                                 (gs-slope (caar e) (cons (- (car a) d) (+ (cdr a) d)) e))))))))))

;;; A sum. Two products with the sine and the cosine of one angle are together at most the length of
;;; the vector that they turn.
(defun gs-iv-sum (x r terms)
  (let ((a (cons 0d0 0d0)) (d 0d0) (turned nil))
    (dolist (y terms)
      (multiple-value-bind (b f) (gs-iv-value x r y)
        (let* ((p (gs-turned y)) (other (and p (assoc (car p) turned :test #'equal))))
          (cond ((null p) (setq a (gs-iv-plus a b) d (gs-clip (+ d f))))
                (other (setq turned (remove other turned :test #'eq))
                       (multiple-value-bind (u du) (gs-iv-value x r (cdr p))
                         (multiple-value-bind (w dw) (gs-iv-value x r (cadr other))
                           (let ((length_ (sqrt (+ (expt (gs-iv-size u) 2)
                                                   (expt (gs-iv-size w) 2))))
                                 (s (gs-iv-plus b (caddr other))))
                             (setq a (gs-iv-plus a
                                                 (cons (max (car s) (- length_))
                                                       (min (cdr s) length_)))
                                   d (+ d
                                        (min (+ f (cadddr other))
                                             (sqrt (+ (expt du 2) (expt dw 2))))))))))
                (t (push (list (gs-partner (car p)) (cdr p) b f) turned))))))
    (dolist (y turned (values a d)) (setq a (gs-iv-plus a (caddr y)) d (+ d (cadddr y))))))

;;; (sine or cosine . the rest) of a term that is a name (or its opposite) of such a product, nil
;;; else
(defun gs-turned (e)
  (let* ((s (cond ((symbolp e) e)
                  ((and (gs-product-p e) (eql (cadr e) -1) (symbolp (caddr e)) (null (cdddr e)))
                   (caddr e))))
         (p (if s (let ((y (gethash s *gs-entries*))) (and y (gs-entry-expression y))) e)))
    (when (and (gs-product-p p) (= (length p) 3) (symbolp (cadr p)) (symbolp (caddr p)))
      (cond ((gethash (cadr p) *gs-trig*) (cons (cadr p) (caddr p)))
            ((gethash (caddr p) *gs-trig*) (cons (caddr p) (cadr p)))))))
(defun gs-partner (s) (cadr (gethash s *gs-trig*)))

;;; the intervals of what has a range, and of the constants in the table h
(defun gs-iv-table (h ranges)
  (let ((x (make-hash-table :test #'eq)))
    (maphash #'(lambda (s v) (when (numberp v) (setf (gethash s x) (cons v v)))) h)
    (dolist (e (cdr ranges) x)
      (setf (gethash (cadr e) x)
            (cons (gs-val-number (cadr (caddr e))) (gs-val-number (caddr (caddr e))))))))

;;; Intervals of code into the table x, bounds of the errors into r; gone: table name -> terms that
;;; are dropped there, or nil.
(defun gs-along (x r code gone)
  (dolist (e code)
    (multiple-value-bind (a d) (gs-iv-value x r (gs-entry-expression e))
      (let ((lost (and gone (gethash (gs-entry-name e) gone))))
        (when lost
          (let ((left (remove-if
                        #'(lambda (y) (member y lost :test #'equal))
                        (cdr (gs-entry-expression e)))))
            (setq d (+ (nth-value 1 (gs-iv-sum x r left)) (gs-iv-size (gs-iv-sum x nil lost)))))))
      (setf (gethash (gs-entry-name e) x) a)
      (unless (zerop d) (setf (gethash (gs-entry-name e) r) d)))))

;;; bounds of the derivatives of one row by the entries: name -> number
(defun gs-iv-adjoint (x code outputs row fixed)
  (let ((b (make-hash-table :test #'eq)))
    (mapc #'(lambda (e w)
              (unless (eql w 0) (gs-iv-spread x b e (gs-iv-size (gs-iv-value x nil w)) fixed)))
              outputs
          row)
    (dolist (e (reverse code) b)
      (let ((w (gethash (gs-entry-name e) b)))
        (when w (gs-iv-spread x b (gs-entry-expression e) w fixed))))))
(defun gs-iv-spread (x b e w fixed)
  (cond ((symbolp e)
         (unless (gethash e fixed) (setf (gethash e b) (gs-clip (+ w (gethash e b 0d0))))))
        ((or (numberp e) (mnump e)) nil)
        (t (case (caar e)
             (mplus (dolist (y (cdr e)) (gs-iv-spread x b y w fixed)))
             (mtimes (dolist (y (cdr e))
                       (unless (or (numberp y) (mnump y))
                         (let ((s w))
                           (dolist (z (cdr e))
                             (unless (eq y z)
                               (setq s (gs-clip (* s (gs-iv-size (gs-iv-value x nil z)))))))
                           (gs-iv-spread x b y s fixed)))))
             (mexpt (let ((n (gs-exponent e)) (a (gs-iv-value x nil (cadr e))))
                      (gs-iv-spread
                        x b (cadr e)
                        (gs-clip (* w
                                    (abs (coerce n 'double-float))
                                    (if (eql n 2) (gs-iv-size a)
                                        (gs-iv-size (gs-iv-power a (1- n))))))
                        fixed)))
             (t (gs-iv-spread
                  x b (cadr e) (* w (gs-slope (caar e) (gs-iv-value x nil (cadr e)) e)) fixed))))))

;;; Bounds by row of what dropping terms ([name, term, ..], ...) from the sums of code changes:
;;; ranges: [symbol = [lo, hi], ...]; h: the constants.
(defun $gs__dropped_bounds (tp h code outputs weights dropped ranges)
  (let ((x (gs-iv-table h ranges)) (r (make-hash-table :test #'eq))
        (gone (make-hash-table :test #'eq)) (*gs-entries* (gs-entries tp))
        (*gs-trig* (nth 6 tp)))
    (dolist (d (cdr dropped)) (push (caddr d) (gethash (cadr d) gone)))
    (gs-along x r (cdr code) gone)
    (cons '(mlist)
          (mapcar #'(lambda (row)
                      (let ((s 0d0))
                        (mapc #'(lambda (e w)
                                  (unless (eql w 0)
                                    (setq s
                                          (+ s
                                             (* (gs-iv-size (gs-iv-value x r w))
                                                (nth-value 1 (gs-iv-value x r e))))))) (cdr outputs)
                              (cdr row))
                        s)) (cdr weights)))))

;;; --------------------------------------------------------------------------------------- definite

;;; Of n states: how many have a matrix (rows of expressions) that is not positive definite, by
;;; Cholesky's elimination.
(defun $gs__sample_indefinite (h rows n)
  (let ((bad 0)
        (v (mapcar #'(lambda (r) (mapcar #'(lambda (e) (gs-val-value h e)) (cdr r))) (cdr rows)))
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
