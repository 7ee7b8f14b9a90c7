;;; gsmbp_text.lisp: the printer of gsmbp_emit.mac: expressions as text of Fortran 77, counted as
;;; they are printed; statements as lines. The state of an emission (gsmbp__emission) is held in
;;; variables of Maxima.
(in-package :maxima)

(declaim
  (special $gsmbp__names $gsmbp__used $gsmbp__numbers $gsmbp__mul $gsmbp__add $gsmbp__div
           $gsmbp__sqrt $gsmbp__trig $gsmbp__body $gsmbp__block $gsmbp__own $gsmbp__where
           $gsmbp__taken $gsmbp__parts))

(defun gsmbp-text (&rest parts) (apply #'concatenate 'string parts))
(defun gsmbp-joined (parts between)
  (if (and (string= between "") (null (nthcdr 40 parts))) (apply #'concatenate 'string parts)
    (with-output-to-string (s)
      (do ((l parts (cdr l))) ((null l))
        (write-string (car l) s)
        (when (cdr l) (write-string between s))))))

(defun $gsmbp__tally ()
  (gsmbp-list (list $gsmbp__mul $gsmbp__add $gsmbp__div $gsmbp__sqrt $gsmbp__trig)))
(defun $gsmbp__set_tally (tally)
  (destructuring-bind (m a d s f) (cdr tally)
    (setq $gsmbp__mul m $gsmbp__add a $gsmbp__div d $gsmbp__sqrt s $gsmbp__trig f)))

;;; Sum of a list of lines as Adler-32 forms it (RFC 1950), of their ASCII characters and a newline
;;; each: "b a" in decimal digits
(defun $gsmbp__checksum (lines)
  (let ((a 1) (b 0))
    (declare (fixnum a b))
    (flet ((add (code)
             (declare (fixnum code))
             (when (< code 128) (setq a (mod (+ a code) 65521) b (mod (+ b a) 65521)))))
      (dolist (line (cdr lines))
        (map nil (lambda (c) (add (char-code c))) line)
        (add 10)))
    (format nil "~d ~d" b a)))

;;; ---------------------------------------------------------------------------------------- numbers

(defun gsmbp-rational (r) (if (integerp r) r (/ (cadr r) (caddr r))))

;;; [n, k] with r = n/10^k and n not divisible by 10 if the rational r > 0 has a finite decimal
;;; fraction; else false
(defun $gsmbp__finite_decimal (r)
  (let* ((q (gsmbp-rational r)) (d (denominator q)) (k 0))
    (flet ((times-of (p) (do ((n 0 (1+ n))) ((plusp (mod d p)) n) (setq d (/ d p)))))
      (setq k (max (times-of 2) (times-of 5)))
      (when (= d 1)
        (let ((n (* q (expt 10 k))))
          (do () ((plusp (mod n 10))) (setq n (/ n 10) k (1- k)))
          (gsmbp-list (list n k)))))))
;;; true if 1e-300 < r < 1e300
(defvar *gsmbp-largest* (expt 10 300))
(defun $gsmbp__representable (r)
  (let ((q (gsmbp-rational r)))
    (and (< (numerator q) (* *gsmbp-largest* (denominator q)))
         (< (denominator q) (* *gsmbp-largest* (numerator q))))))

;;; n/10^k (n > 0, not divisible by 10) as text: plain, or with an exponent behind `mark` when it is
;;; small or large
(defun $gsmbp__decimal_text (n k mark)
  (let* ((s (format nil "~d" n)) (p (- (length s) k)))          ; the number is 0.s * 10^p
    (flet ((zeros (n) (make-string (max 0 n) :initial-element #\0)))
      (cond ((or (< p -1) (> p 7)) (gsmbp-text (gsmbp-pointed s 1) mark (format nil "~d" (1- p))))
            ((<= p 0) (gsmbp-text "0." (zeros (- p)) s))
            (t (gsmbp-pointed (gsmbp-text s (zeros (- p (length s)))) p))))))
;;; the digits s with a point behind the p-th and at least one digit behind the point
(defun gsmbp-pointed (s p) (gsmbp-text (subseq s 0 p) "." (if (> (length s) p) (subseq s p) "0")))

;;; [n, k] as a DOUBLE PRECISION constant
(defun $gsmbp__constant (d)
  (let ((text ($gsmbp__decimal_text (cadr d) (caddr d) "D")))
    (if (find #\D text) text (gsmbp-text text "D0"))))

;;; --------------------------------------------------------------------------- sums, terms, factors

;;; any expression: a sum with a positive term ahead if it has one
(defun $gsmbp__sum_text (e)
  (if (symbolp e)
      (gsmbp-name-text e)
      (gsmbp-joined (cdr ($gsmbp__signed_pieces ($gsmbp__signed_terms e))) "")))

;;; the summands of e (one, if e is no sum) as [sign, text, summand], sign "+" or "-"; the first
;;; positive one ahead
(defun $gsmbp__signed_terms (e)
  (if (not (gsmbp-sum-p e))
      (gsmbp-list (list (gsmbp-signed-term e)))
      (let* ((terms (mapcar #'gsmbp-signed-term (cdr e)))
             (lead (find "+" terms :key #'cadr :test #'string=)))
        (incf $gsmbp__add (1- (length terms)))
        (gsmbp-list
          (if (or (null lead) (eq lead (car terms)))
              terms
              (cons lead (remove lead terms :test #'eq)))))))

;;; terms as pieces of text: "A", " + B*C", " - D"
(defun $gsmbp__signed_pieces (terms)
  (destructuring-bind (first &rest others) (cdr terms)
    (gsmbp-list (cons (if (string= (cadr first) "-") (gsmbp-text "-" (caddr first)) (caddr first))
                      (mapcar #'(lambda (x) (gsmbp-text " " (cadr x) " " (caddr x))) others)))))

(defun gsmbp-signed-term (e)
  (cond ((symbolp e) (gsmbp-list (list "+" (gsmbp-name-text e) e)))
        ((mnump e) (gsmbp-signed e (gsmbp-number-text (gsmbp-magnitude e)) e))
        ((gsmbp-product-p e)
         (let ((c (cadr e)))
           (if (mnump c)
               (gsmbp-signed c (gsmbp-product-text (gsmbp-magnitude c) (cddr e)) e)
               (gsmbp-signed 1 (gsmbp-product-text 1 (cdr e)) e))))
        (t (gsmbp-signed
             1 (if (gsmbp-power-p e) (gsmbp-product-text 1 (list e)) (gsmbp-factor-text e)) e))))
(defun gsmbp-signed (number text e)
  (gsmbp-list (list (if (gsmbp-negative-p number) "-" "+") text e)))

;;; a number >= 0 as constants: one, or two whose quotient it is; as a term (its division is
;;; counted)
(defun gsmbp-number-parts (r)
  (cdr (or (gethash r $gsmbp__numbers)
           (setf (gethash r $gsmbp__numbers) (mfuncall '$gsmbp__constants (gsmbp-exact r))))))
(defun gsmbp-number-text (r)
  (let ((p (gsmbp-number-parts r)))
    (when (cdr p) (incf $gsmbp__div))
    (gsmbp-joined p "/")))

;;; a number c > 0 times factors; powers with a negative exponent become divisors
(defun gsmbp-product-text (c factors)
  (let ((above nil) (below nil))
    (dolist (f factors)
      (cond ((symbolp f) (push (gsmbp-name-text f) above))
            ((not (gsmbp-power-p f)) (push (gsmbp-factor-text f) above))
            ((and (mnump (caddr f)) (gsmbp-negative-p (caddr f)) (not (eq (cadr f) '$%e)))
             (setq below (append (gsmbp-power-texts (cadr f) (gsmbp-minus (caddr f))) below)))
            (t (setq above (append (gsmbp-power-texts (cadr f) (caddr f)) above)))))
    (if (eql c 1) (gsmbp-fraction-text (reverse above) (reverse below))
      (gsmbp-scaled-text (gsmbp-exact c) (reverse above) (reverse below)))))

;;; the same with texts of the factors: a decimal fraction is a factor, 1/3 a divisor, 2/3 a factor
;;; (2.0D0/3.0D0)
(defun gsmbp-scaled-text (c above below)
  (let ((k (gsmbp-number-parts c)))
    (cond ((eql c 1) (gsmbp-fraction-text above below))
          ((null (cdr k)) (gsmbp-fraction-text (cons (car k) above) below))
          ((eql (cadr c) 1) (gsmbp-fraction-text above (cons (cadr k) below)))
          (below (gsmbp-fraction-text (cons (car k) above) (cons (cadr k) below)))
          (t (incf $gsmbp__div)
             (gsmbp-fraction-text (cons (gsmbp-text "(" (car k) "/" (cadr k) ")") above) nil)))))

(defun gsmbp-fraction-text (above below)
  (let ((text (if above (gsmbp-joined above "*") "1.0D0")))
    (when (cdr above) (incf $gsmbp__mul (1- (length above))))
    (cond ((null below) text)
          (t (incf $gsmbp__div) (incf $gsmbp__mul (1- (length below)))
             (if (cdr below)
                 (gsmbp-text text "/(" (gsmbp-joined below "*") ")")
                 (gsmbp-text text "/" (car below)))))))

;;; b^n as factors in reverse order; n > 0 if it is a number
(defun gsmbp-power-texts (b n)
  (if (eq b '$%e)
      (progn (incf $gsmbp__trig) (list (gsmbp-text "EXP(" ($gsmbp__sum_text n) ")")))
      (let ((h (if (mnump n) (gsmbp-times 2 (gsmbp-exact n)))))
        (cond ((not (integerp h))
               (incf $gsmbp__trig)
               (list (gsmbp-text (gsmbp-base-text b) "**" (gsmbp-factor-text n))))
              ((evenp h) (gsmbp-integer-power b (/ h 2)))
              (t (incf $gsmbp__sqrt)
                 (cons (gsmbp-text "SQRT(" ($gsmbp__sum_text b) ")")
                       (gsmbp-integer-power b (/ (1- h) 2))))))))

(defun gsmbp-integer-power (b n)
  (case n
    (0 nil)
    (1 (list (gsmbp-factor-text b)))
    (t (incf $gsmbp__mul (1- n)) (list (gsmbp-text (gsmbp-base-text b) "**" (format nil "~d" n))))))
(defun gsmbp-base-text (b)
  (if (gsmbp-power-p b) (gsmbp-text "(" ($gsmbp__sum_text b) ")") (gsmbp-factor-text b)))

(defun gsmbp-factor-text (e)
  (cond ((mnump e) (gsmbp-number-factor e))
        ((atom e) (gsmbp-name-text e))
        ((or (gsmbp-sum-p e) (gsmbp-product-p e)) (gsmbp-text "(" ($gsmbp__sum_text e) ")"))
        ((gsmbp-power-p e) (gsmbp-power-factor (cadr e) (caddr e) e))
        (t (gsmbp-call-text ($op e) (cdr e)))))

;;; a call of a function with its arguments
(defun gsmbp-call-text (f arguments)
  (let ((e (mfuncall '$assoc f (mfuncall '$gsmbp__functions))) (n (length arguments)))
    (unless e (mfuncall '$gsmbp__error $gsmbp__where "Fortran 77 has no function " f))
    (destructuring-bind (name arity) (cdr e)
      (when (if (eql arity 0) (< n 2) (/= n arity))
        (mfuncall '$gsmbp__error $gsmbp__where "wrong number of arguments of " f ": " n))
      (cond ((string= name "SQRT") (incf $gsmbp__sqrt))
            ((not (member name '("ABS" "MAX" "MIN" "ANINT" "GSFLR") :test #'string=))
             (incf $gsmbp__trig)))
      (gsmbp-text name "(" (gsmbp-joined (mapcar #'$gsmbp__sum_text arguments) ", ") ")"))))

(defun gsmbp-number-factor (e)
  (let* ((d $gsmbp__div) (s (gsmbp-number-text (gsmbp-magnitude e))))
    (cond ((gsmbp-negative-p e) (gsmbp-text "(-" s ")"))
          ((> $gsmbp__div d) (gsmbp-text "(" s ")"))
          (t s))))

;;; a power where one factor is wanted: x^2, sqrt(x) and exp(x) are one; 1/x and x*sqrt(x) need
;;; parentheses
(defun gsmbp-power-factor (b n e)
  (if (and (mnump n) (gsmbp-negative-p n) (not (eq b '$%e)))
      (gsmbp-text "(" (gsmbp-product-text 1 (list e)) ")")
      (let ((l (gsmbp-power-texts b n)))
        (incf $gsmbp__mul (1- (length l)))
        (if (cdr l) (gsmbp-text "(" (gsmbp-joined (reverse l) "*") ")") (car l)))))

;;; the name of a symbol, which from now on counts as used
; hash table, symbol -> source: those that are loaded ahead of the first statement that uses them;
; or false
(defvar $gsmbp__late nil)
(defvar *gsmbp-due* nil)                 ; (name . source) of those that wait for the next statement
(defun gsmbp-name-text (x)
  (setf (gethash x $gsmbp__used) t)
  (let ((source (and $gsmbp__late (gethash x $gsmbp__late))))
    (when source
      (remhash x $gsmbp__late)
      (push (cons (gethash x $gsmbp__names) source) *gsmbp-due*)))
  (or (gethash x $gsmbp__names) (mfuncall '$gsmbp__nameless_text x)))

;;; ------------------------------------------------------------------------------------------ lines

;;; A statement given in pieces, broken between them where that will do, as lines of fixed form.
(defun $gsmbp__packed_lines (pieces)
  (let ((lines nil) (line (list "      ")) (width 66))
    (dolist (p (cdr pieces) (gsmbp-list (nreverse (cons (gsmbp-joined (nreverse line) "") lines))))
      (cond ((<= (length p) width) (push p line) (decf width (length p)))
            (t (push (gsmbp-joined (nreverse line) "") lines)
               (setq p (string-left-trim " " p) line (list p "     $   ") width (- 63 (length p)))
               (when (< width 0)
                 (return (mfuncall '$gsmbp__statement_lines (gsmbp-joined (cdr pieces) "") ""
                                   0))))))))

(defun $gsmbp__push (lines)
  (gsmbp-tick)
  (let ((due (reverse *gsmbp-due*)))
    (setq *gsmbp-due* nil)
    (dolist (d due) (gsmbp-push-line (gsmbp-load-line (car d) (cdr d)))))
  (dolist (l (cdr lines)) (gsmbp-push-line l)))
(defun gsmbp-push-line (l) (setq $gsmbp__body (gsmbp-list (cons l (cdr $gsmbp__body)))))
(defun gsmbp-load-line (name source)
  ($gsmbp__own_name name)
  (gsmbp-text "      " name " = " source))

;;; target = expression, as one statement if 20 lines hold it
(defun $gsmbp__assign (target e)
  (let* ((tally ($gsmbp__tally))
         (lines ($gsmbp__assignment target ($gsmbp__signed_pieces ($gsmbp__signed_terms e)))))
    (cond ((<= (length (cdr lines)) 20) ($gsmbp__push lines))
          (t ($gsmbp__set_tally tally) (gsmbp-assign-long target e)))))
(defun $gsmbp__assignment (target pieces)
  ($gsmbp__packed_lines (gsmbp-list (cons (gsmbp-text target " = " (cadr pieces)) (cddr pieces)))))

;;; the lines of one entry [target, expression, block] of the code
(defun gsmbp-code-line (c)
  (destructuring-bind (s e heading) (cdr c)
    (unless (equal heading $gsmbp__block) (gsmbp-open-block heading))
    (cond ((consp s) (gsmbp-sine-call s e))
          ((and s (symbolp s) (not (stringp e)))
           (let ((n (gsmbp-target s)))
             ($gsmbp__assign n e)
             (setf (gethash s $gsmbp__names) n)))
          (t (gsmbp-code-text s e)))))
;;; the variable of a symbol, a new one if it has none
(defun gsmbp-target (s)
  (or (gethash s $gsmbp__names)
      (let ((n ($gsmbp__fresh s))) ($gsmbp__own_name n) n)))

;;; a comment line where another block begins
(defun gsmbp-open-block (heading)
  (when (member heading '($trig "trig") :test #'equal) (setq heading "sines and cosines"))
  (when (and (stringp heading) (string/= heading "") (not (equal heading $gsmbp__block)))
    ($gsmbp__push ($gsmbp__filled heading "C     -- " "C        ")))
  (setq $gsmbp__block heading))

;;; an assignment to what is given as text, or a right side or a statement that is text
(defun gsmbp-code-text (s e)
  (let ((n (if (and s (not (stringp s))) (setf (gethash s $gsmbp__names) (gsmbp-target s)) s)))
    (cond ((not (stringp e)) ($gsmbp__assign n e))
          (t (when s (setq e (gsmbp-text n " = " e)))
             (mfuncall '$gsmbp__count_raw (gsmbp-list (list e)))
             ($gsmbp__push (mfuncall '$gsmbp__raw_lines e))))))

;;; ------------------------------------------------------------------------ long statements

(defun gsmbp-assign-long (target e)
  (if (gsmbp-sum-p e) (gsmbp-assign-sum target e) ($gsmbp__assign target (gsmbp-shortened e))))

;;; length of an expression as text; counts nothing
(defun gsmbp-text-length (e)
  (let ((tally ($gsmbp__tally)))
    (prog1 (length ($gsmbp__sum_text e)) ($gsmbp__set_tally tally))))

;;; a new symbol whose variable holds the expression
(defun gsmbp-part (e)
  (let* ((k (incf $gsmbp__parts)) (s ($concat '$gsmbp__part_ k))
         (n ($gsmbp__fresh (gsmbp-text "PART" (format nil "~d" k)))))
    ($gsmbp__own_name n)
    ($gsmbp__assign n e)
    (setf (gethash s $gsmbp__names) n)
    s))

;;; A long sum in partial sums of some 700 characters, in the target itself: 20 lines hold that,
;;; whatever the names are.
(defun gsmbp-assign-sum (target e)
  (let ((e (gsmbp-mapped #'(lambda (x) (if (> (gsmbp-text-length x) 600) (gsmbp-part x) x)) e))
        (chunk nil) (size 0) (so-far nil))
    (if (not (gsmbp-sum-p e)) ($gsmbp__assign target e)
      (dolist (x (cdr ($gsmbp__signed_terms e)) (gsmbp-push-sum target so-far (reverse chunk)))
        (let ((wide (length (caddr x))))
          (when (> (+ size wide) 700)
            (gsmbp-push-sum target so-far (reverse chunk))
            (setq so-far target chunk nil size 0))
          (push x chunk)
          (incf size (+ wide 3)))))))
(defun gsmbp-mapped (f e) (simplifya (cons (list (caar e)) (mapcar f (cdr e))) nil))

;;; a partial sum, as several statements where one would need more than 20 lines
(defun gsmbp-push-sum (target so-far terms)
  (let ((lines (gsmbp-partial-sum target so-far terms)) (n (length terms)))
    (if (or (<= (length (cdr lines)) 20) (= n 1)) ($gsmbp__push lines)
      (let ((half (floor n 2)))
        (gsmbp-push-sum target so-far (subseq terms 0 half))
        (gsmbp-push-sum target target (subseq terms half))))))
(defun gsmbp-partial-sum (target so-far terms)
  (let ((terms (if so-far (cons (gsmbp-list (list "+" so-far)) terms) terms)))
    ($gsmbp__assignment target ($gsmbp__signed_pieces (gsmbp-list terms)))))

;;; a product, power or call whose long parts are variables
(defun gsmbp-shortened (e)
  (let ((n (length (cdr e))))
    (if (and (gsmbp-product-p e) (> n 12))
        (let ((half (floor n 2)))
          (mul (gsmbp-part (muln (subseq (cdr e) 0 half) nil))
               (gsmbp-part (muln (subseq (cdr e) half) nil))))
      (gsmbp-mapped #'(lambda (x)
                        (cond ((or ($mapatom x) (<= (gsmbp-text-length x) 31)) x)
                              ((gsmbp-power-p x) (gsmbp-shortened x))
                              (t (gsmbp-part x))))
                    e))))

;;; --------------------------------------------------------------------- sines and cosines

;;; [sine, cosine] of an angle by one call; $idle: what nobody asked for
(defun gsmbp-sine-call (pair angle)
  (let ((names (mapcar #'gsmbp-target (cdr pair))))
    (incf $gsmbp__trig (count '$idle (cdr pair) :test-not #'eq))
    ($gsmbp__push
      ($gsmbp__packed_lines
        (gsmbp-list
          (list (gsmbp-text "CALL GSSC( " ($gsmbp__sum_text angle) ", ")
                (car names)
                ", "
                (cadr names)
                " )"))))
    (mapc #'(lambda (s n) (setf (gethash s $gsmbp__names) n)) (cdr pair) names)))

;;; The code with [[sine, cosine], angle, block] in the place of the first of the entries under the
;;; heading trig that are the sine or cosine of an angle.
(defun $gsmbp__sine_pairs (code)
  (let ((pairs nil) (kept nil))
    (dolist (c (cdr code) (gsmbp-list (nreverse kept)))
      (destructuring-bind (s e heading) (cdr c)
        (if (not (and (eq heading '$trig) (consp e) (member (caar e) '(%sin %cos)))) (push c kept)
          (let ((p (assoc (cadr e) pairs :test #'alike1)))
            (unless p
              (push (setq p (cons (cadr e) (gsmbp-list (list '$idle '$idle)))) pairs)
              (push (gsmbp-list (list (cdr p) (cadr e) heading)) kept))
            (setf (nth (if (eq (caar e) '%sin) 1 2) (cdr p)) s)))))))
(defun $gsmbp__code_lines (code) (dolist (c (cdr code)) (gsmbp-code-line c)))
(defun $gsmbp__own_name (n) (setq $gsmbp__own (gsmbp-list (cons n (cdr $gsmbp__own)))))

;;; the declaration of some names, or several if one would need more than 20 lines
(defun $gsmbp__declaration (type names) (gsmbp-list (gsmbp-declared type (cdr names))))
(defun gsmbp-declared (type names)
  (let* ((n (length names)) (half (floor n 2))
         (lines (if (<= 1 n 200)
                    (cdr ($gsmbp__packed_lines
                           (gsmbp-list
                             (cons (gsmbp-text type (car names) (if (cdr names) "," ""))
                                   (maplist #'(lambda (l)
                                                (gsmbp-text " " (car l) (if (cdr l) "," "")))
                                            (cdr names)))))))))
    (cond ((null names) nil)
          ((and lines (<= (length lines) 20)) lines)
          (t (mapcan #'(lambda (part) (gsmbp-declared type (cdr part)))
                     (cdr ($gsmbp__cut_at (gsmbp-list names) half)))))))

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

;;; a text filled into lines of at most 72 characters: `head` ahead of the first, `tail` ahead of
;;; the others
(defun $gsmbp__filled (text head tail)
  (let ((lines nil) (line (list head)) (width (length head)))
    (dolist (w (gsmbp-split text)
               (gsmbp-list
                 (nreverse (cons (string-right-trim " " (gsmbp-joined (nreverse line) "")) lines))))
      (cond ((null (cdr line)) (push w line) (incf width (length w)))
            ((<= (+ width 1 (length w)) 72)
             (push " " line)
             (push w line)
             (incf width (1+ (length w))))
            (t (push (gsmbp-joined (nreverse line) "") lines)
               (setq line (list w tail) width (+ (length tail) (length w))))))))
(defun gsmbp-split (text)                ; its words
  (let ((words nil) (from 0))
    (loop
      (let ((to (position #\Space text :start from)))
        (unless (eql from (or to (length text))) (push (subseq text from to) words))
        (unless to (return (nreverse words)))
        (setq from (1+ to))))))

;;; the right sides that are text
(defun $gsmbp__code_texts (code) (gsmbp-list (remove-if-not #'stringp (mapcar #'caddr (cdr code)))))

;;; the code with the sines and cosines ahead whose arguments are known at once
(defun $gsmbp__trig_first (load code)
  (let ((ready (make-hash-table :test #'eq)) (front nil) (back nil))
    (dolist (l (cdr load)) (setf (gethash (cadr l) ready) t))
    (dolist (c (cdr code) (gsmbp-list (append (reverse front) (reverse back))))
      (destructuring-bind (s e heading) (cdr c)
        (cond ((and (member heading '($trig "trig") :test #'equal)
                    (every #'(lambda (x) (gethash x ready)) (cdr ($gsmbp__symbols e))))
               (push c front)
               (setf (gethash s ready) t))
              (t (push c back)))))))

;;; ------------------------------------------------------------------------------------------ names

;;; Names for the loaded symbols [symbol, source]; a source that is an argument itself is used as it
;;; stands.
(defun $gsmbp__name_loads (load arguments)
  (dolist (l (cdr load))
    (let ((source (string-upcase (caddr l))))
      (setf (gethash (cadr l) $gsmbp__names)
            (if (member source (cdr arguments) :test #'string=) source ($gsmbp__fresh (cadr l)))))))

;;; the assignments of those whose symbol was printed or whose name the hash table raw holds
(defun $gsmbp__loads (load raw)
  (let ((lines nil))
    (dolist (l (cdr load) (gsmbp-list (nreverse lines)))
      (let ((n (gethash (cadr l) $gsmbp__names)))
        (when (and (string/= n (string-upcase (caddr l)))
                   (or (gethash (cadr l) $gsmbp__used) (gethash n raw)))
          (push (gsmbp-load-line n (caddr l)) lines))))))

;;; hash table, symbol -> source, of the loaded symbols but those whose name the hash table raw
;;; holds
(defun $gsmbp__to_load_late (load raw)
  (let ((h (make-hash-table :test #'eq)))
    (dolist (l (cdr load) h)
      (let ((n (gethash (cadr l) $gsmbp__names)))
        (unless (or (string= n (string-upcase (caddr l))) (gethash n raw))
          (setf (gethash (cadr l) h) (caddr l)))))))

;;; A free name for a symbol: its own in capitals, else with _ behind it, else _2, _3, ...
(defun $gsmbp__fresh (symbol)
  (let* ((base (gsmbp-fit (string-upcase ($sconcat symbol)))) (n base) (k 1))
    (loop
      (unless (gethash n $gsmbp__taken) (return))
      (setq n (if (= k 1) (gsmbp-text base "_") (format nil "~a_~d" base k)) k (1+ k)))
    (setf (gethash n $gsmbp__taken) t)
    n))

;;; letters, digits and _ only, a letter first, at most 26 characters (a rename needs five)
(defun gsmbp-letter-p (c) (and (< (char-code c) 128) (alpha-char-p c)))
(defun gsmbp-word-character-p (c) (or (gsmbp-letter-p c) (digit-char-p c) (char= c #\_)))
(defun gsmbp-fit (s)
  (let ((c (substitute-if-not #\_ #'gsmbp-word-character-p s)))
    (unless (gsmbp-letter-p (char c 0)) (setq c (gsmbp-text "X" c)))
    (subseq c 0 (min 26 (length c)))))
(defun $gsmbp__is_fit (s)
  (and (<= 1 (length s) 24) (gsmbp-letter-p (char s 0)) (every #'gsmbp-word-character-p s)))

;;; ------------------------------------------------------------------------------------------- JSON

;;; a string in quotes; quote, backslash and control characters escaped
(defun $gsmbp__json_string (s)
  (with-output-to-string (o)
    (write-char #\" o)
    (dotimes (i (length s) (write-char #\" o))
      (let* ((c (char s i)) (n (char-code c)))
        (cond ((member n '(34 92)) (write-char #\\ o) (write-char c o))
              ((= n 10) (write-string "\\n" o))
              ((= n 9) (write-string "\\t" o))
              ((< n 32) (format o "\\u00~(~2,'0x~)" n))
              (t (write-char c o)))))))

;;; a value on one line
(defun $gsmbp__json_inline (v)
  (cond ((stringp v) ($gsmbp__json_string v))
        ((null v) "false")
        ((eq v t) "true")
        ((and (symbolp v) (not ($constantp v))) ($gsmbp__json_string ($sconcat v)))
        (($gsmbp__json_objectp v)
         (gsmbp-text "{" (gsmbp-joined (mapcar #'gsmbp-json-pair (cdr v)) ", ") "}"))
        (($listp v) (gsmbp-text "[" (gsmbp-joined (mapcar #'$gsmbp__json_inline (cdr v)) ", ") "]"))
        (t (or (gsmbp-json-decimal v) (mfuncall '$gsmbp__json_number v)))))

;;; a number that is a short integer or decimal fraction, else nil
(defun gsmbp-json-decimal (v)
  (cond ((integerp v) (and (< (abs v) (expt 10 16)) (format nil "~d" v)))
        ((ratnump v)
         (let ((d ($gsmbp__finite_decimal (gsmbp-magnitude v))))
           (and d
                (< (cadr d) (expt 10 20))
                (gsmbp-text
                  (if (gsmbp-negative-p v) "-" "")
                  ($gsmbp__decimal_text (cadr d) (caddr d) "e")))))))

(defun gsmbp-json-key (e) (gsmbp-text ($gsmbp__json_string ($sconcat (cadr e))) ": "))
(defun gsmbp-json-pair (e) (gsmbp-text (gsmbp-json-key e) ($gsmbp__json_inline (caddr e))))
(defun $gsmbp__json_objectp (v)
  (and (consp v)
       (or (and (eq (caar v) '$set) (null (cdr v)))
           (and ($listp v)
                (cdr v)
                (every #'(lambda (e) (and (consp e) (eq (caar e) 'mequal))) (cdr v))))))

;;; the lines of v: `lead` (a key) ahead of it, `tail` (a comma) behind it
(defun $gsmbp__json_block (indent v lead tail) (gsmbp-list (gsmbp-json-lines indent v lead tail)))
(defun gsmbp-json-lines (indent v lead tail)
  (let* ((object ($gsmbp__json_objectp v)) (parts (and (or object ($listp v)) (cdr v)))
         (text (if (or (null parts) (string/= indent ""))
                   (gsmbp-text indent lead ($gsmbp__json_inline v) tail))))
    (if (and text (or (null parts) (<= (length text) 150)))
        (list text)
        (let ((lines (list (gsmbp-text indent lead (if object "{" "["))))
              (inner (gsmbp-text indent "  ")))
          (do ((l parts (cdr l)))
              ((null l))
            (setq lines
                  (revappend
                    (gsmbp-json-lines
                      inner (if object (caddr (car l)) (car l))
                      (if object (gsmbp-json-key (car l)) "") (if (cdr l) "," "")) lines)))
          (reverse (cons (gsmbp-text indent (if object "}" "]") tail) lines))))))
