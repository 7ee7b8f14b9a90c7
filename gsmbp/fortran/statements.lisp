;;; fortran/statements.lisp: assignments and calls as statements; long ones in several.
(in-package :maxima)

;;; target = expression, as one statement if 20 lines hold it
(defun $gsmbp__assign (target e)
  (let* ((tally ($gsmbp__tally))
         (lines ($gsmbp__assignment target ($gsmbp__signed_pieces ($gsmbp__signed_terms e)))))
    (cond ((<= (length (cdr lines)) 20) ($gsmbp__push lines))
          (t ($gsmbp__set_tally tally) (gsmbp-assign-long target e)))))

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
