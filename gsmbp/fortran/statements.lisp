;;; fortran/statements.lisp: assignments and calls as statements; long ones in several.
(in-package :maxima)

;;; target = expression, as one statement if 20 lines hold it
(defun $gs__assign (target e)
  (let* ((tally ($gs__tally))
         (lines ($gs__assignment target ($gs__signed_pieces ($gs__signed_terms e)))))
    (cond ((<= (length (cdr lines)) 20) ($gs__push lines))
          (t ($gs__set_tally tally) (gs-assign-long target e)))))

;;; the lines of one entry [target, expression, block] of the code
(defun gs-code-line (c)
  (destructuring-bind (s e heading) (cdr c)
    (unless (equal heading $gs__block) (gs-open-block heading))
    (cond ((consp s) (gs-sine-call s e))
          ((and s (symbolp s) (not (stringp e)))
           (let ((n (gs-target s)))
             ($gs__assign n e)
             (gs-give s n (gs-delay e))))
          (t (gs-code-text s e)))))

;;; the variable of a symbol, a new one if it has none
(defun gs-target (s)
  (or (gethash s $gs__names)
      (let ((n ($gs__fresh s))) ($gs__own_name n) n)))

;;; a comment line where another block begins
(defun gs-open-block (heading)
  (when (member heading '($trig "trig") :test #'equal) (setq heading "sines and cosines"))
  (when (and (stringp heading) (string/= heading "") (not (equal heading $gs__block)))
    ($gs__push ($gs__filled heading "C     -- " "C        ")))
  (setq $gs__block heading))

;;; an assignment to what is given as text, or a right side or a statement that is text
(defun gs-code-text (s e)
  (let ((n (if (and s (not (stringp s)))
               (gs-give s (gs-target s) (if (stringp e) 100 (gs-delay e)))
               s)))
    (cond ((not (stringp e)) ($gs__assign n e))
          (t (when s (setq e (gs-text n " = " e)))
             (mfuncall '$gs__count_raw (gs-list (list e)))
             ($gs__push (mfuncall '$gs__raw_lines e))))))

(defun gs-assign-long (target e)
  (if (gs-sum-p e) (gs-assign-sum target e) ($gs__assign target (gs-shortened e))))

;;; length of an expression as text; counts nothing
(defun gs-text-length (e)
  (let ((tally ($gs__tally)))
    (prog1 (length ($gs__sum_text e)) ($gs__set_tally tally))))

;;; a new symbol whose variable holds the expression
(defun gs-part (e)
  (let* ((k (incf $gs__parts)) (s ($concat '$gs__part_ k))
         (n ($gs__fresh (gs-text "PART" (format nil "~d" k)))))
    ($gs__own_name n)
    ($gs__assign n e)
    (gs-give s n (gs-delay e))
    s))

;;; A long sum in partial sums of some 700 characters, in the target itself: 20 lines hold that,
;;; whatever the names are.
(defun gs-assign-sum (target e)
  (let ((e (gs-mapped #'(lambda (x) (if (> (gs-text-length x) 600) (gs-part x) x)) e))
        (chunk nil) (size 0) (so-far nil))
    (if (not (gs-sum-p e)) ($gs__assign target e)
      (dolist (x (cdr ($gs__signed_terms e)) (gs-push-sum target so-far (reverse chunk)))
        (let ((wide (length (caddr x))))
          (when (> (+ size wide) 700)
            (gs-push-sum target so-far (reverse chunk))
            (setq so-far target chunk nil size 0))
          (push x chunk)
          (incf size (+ wide 3)))))))

(defun gs-mapped (f e) (simplifya (cons (list (caar e)) (mapcar f (cdr e))) nil))

;;; a partial sum, as several statements where one would need more than 20 lines
(defun gs-push-sum (target so-far terms)
  (let ((lines (gs-partial-sum target so-far terms)) (n (length terms)))
    (if (or (<= (length (cdr lines)) 20) (= n 1)) ($gs__push lines)
      (let ((half (floor n 2)))
        (gs-push-sum target so-far (subseq terms 0 half))
        (gs-push-sum target target (subseq terms half))))))

(defun gs-partial-sum (target so-far terms)
  (let ((terms (if so-far (cons (gs-list (list "+" so-far)) terms) terms)))
    ($gs__assignment target ($gs__signed_pieces (gs-list terms)))))

;;; a product, power or call whose long parts are variables
(defun gs-shortened (e)
  (let ((n (length (cdr e))))
    (if (and (gs-product-p e) (> n 12))
        (let ((half (floor n 2)))
          (mul (gs-part (muln (subseq (cdr e) 0 half) nil))
               (gs-part (muln (subseq (cdr e) half) nil))))
      (gs-mapped #'(lambda (x)
                     (cond ((or ($mapatom x) (<= (gs-text-length x) 31)) x)
                           ((gs-power-p x) (gs-shortened x))
                           (t (gs-part x))))
                 e))))

;;; [sine, cosine] of an angle by one call; $idle: what nobody asked for
(defun gs-sine-call (pair angle)
  (let ((names (mapcar #'gs-target (cdr pair))))
    (incf $gs__n_trig (count '$idle (cdr pair) :test-not #'eq))
    ($gs__push
      ($gs__packed_lines
        (gs-list
          (list (gs-text "CALL GSSC( " ($gs__sum_text angle) ", ")
                (car names)
                ", "
                (cadr names)
                " )"))))
    (let ((delay (+ 40 (gs-delay angle))))
      (mapc #'(lambda (s n) (gs-give s n delay)) (cdr pair) names))))

;;; The code with [[sine, cosine], angle, block] in the place of the first of the entries under the
;;; heading trig that are the sine or cosine of an angle.
(defun $gs__sine_pairs (code)
  (let ((pairs nil) (kept nil))
    (dolist (c (cdr code) (gs-list (nreverse kept)))
      (destructuring-bind (s e heading) (cdr c)
        (if (not (and (eq heading '$trig) (consp e) (member (caar e) '(%sin %cos)))) (push c kept)
          (let ((p (assoc (cadr e) pairs :test #'alike1)))
            (unless p
              (push (setq p (cons (cadr e) (gs-list (list '$idle '$idle)))) pairs)
              (push (gs-list (list (cdr p) (cadr e) heading)) kept))
            (setf (nth (if (eq (caar e) '%sin) 1 2) (cdr p)) s)))))))

(defun $gs__code_lines (code) (dolist (c (cdr code)) (gs-code-line c)))

;;; the headings of the code, each once
(defun $gs__headings (code)
  (let ((l nil))
    (dolist (c (cdr code) (gs-list (nreverse l)))
      (pushnew (cadddr c) l :test #'equal))))
;;; the ways of the table [[words, way], ...] whose words one of the headings begins with
(defun $gs__ways_of_blocks (headings table)
  (let ((titles (remove-if-not #'stringp (cdr headings))))
    (gs-list (loop for (nil words way) in (cdr table)
                   when (some #'(lambda (title) (eql 0 (search words title))) titles)
                     collect way))))
