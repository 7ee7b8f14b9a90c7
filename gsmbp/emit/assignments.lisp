;;; emit/assignments.lisp: assignments and calls as statements; long ones in several.
(in-package :maxima)

;;; lines behind those that there are, behind the loads that were waiting for a statement
(defun $gs__push (lines)
  (gs-tick)
  (let ((due (reverse $gs__due)))
    (setq $gs__due nil)
    (dolist (d due) (gs-push-lines (gs-load-lines (car d) (cdr d)))))
  (gs-push-lines (cdr lines)))
(defun gs-push-lines (lines)
  (dolist (l lines) (setq $gs__body (gs-list (cons l (cdr $gs__body))))))

;;; target = expression, as one statement if the language allows for its lines
(defun $gs__assign (target e)
  (let ((lines ($gs__assignment target ($gs__signed_pieces ($gs__signed_terms e)))))
    (if (gs-fits-p lines) ($gs__push lines) (gs-assign-long target e))))
(defun $gs__assignment (target pieces)
  (gs-said '$statement (gs-list (cons (gs-text target " = " (cadr pieces)) (cddr pieces)))))
(defun gs-fits-p (lines)
  (let ((most (gs-said-of '$most_lines))) (or (null most) (<= (length (cdr lines)) most))))

;;; the lines of one entry [target, value, block] of the code
(defun gs-code-line (c)
  (destructuring-bind (target value heading) (cdr c)
    (unless (equal heading $gs__block) (gs-open-block heading))
    (cond (($listp target) (gs-sine-call target value))
          ((null target) (gs-said '$written value))
          ((not (symbolp target)) ($gs__assign (gs-place-text target) value))
          ((or (stringp value) (gs-place-p value)) (gs-copy target (gs-place-text value)))
          (t
           (let* ((new (gs-new-p target)) (n (gs-target target)))
             ($gs__assign (gs-opened n new) value)
             (gs-give target n (gs-delay value)))))))

;;; a symbol becomes what stands in an array
(defun gs-copy (symbol text)
  (let* ((new (gs-new-p symbol)) (n (gs-target symbol)))
    (gs-give symbol n 100)
    ($gs__push (gs-said '$statement (gs-list (list (gs-text (gs-opened n new) " = " text)))))))

;;; statements, and entries of the code among them
(defun $gs__write_body (body)
  (dolist (s (cdr body))
    (if ($listp s) (gs-code-line s)
      (progn (setq $gs__block "") (gs-said '$written s)))))
(defun $gs__code_lines (code) (dolist (c (cdr code)) (gs-code-line c)))

;;; a comment line where another block begins
(defun gs-open-block (heading)
  (when (member heading '($trig "trig") :test #'equal) (setq heading "sines and cosines"))
  (when (and (stringp heading) (string/= heading "") (not (equal heading $gs__block)))
    ($gs__push (gs-said '$comment heading)))
  (setq $gs__block heading))

;;; a statement that declares the variables of new symbols, where the language does
(defun gs-declare-new (symbols)
  (let ((new (remove-duplicates (remove-if-not #'gs-new-p symbols))))
    (when (and new $gs__declares)
      (let ((names (mapcar #'gs-target new)))
        (mapc #'(lambda (s n) (setf (gethash s $gs__names) n)) new names)
        ($gs__push (gs-said '$statement
                            (gs-list (list (caddr $gs__declares) (gs-joined names ", ")))))))))

;;; [name of the sine, of the cosine] of an angle, from now on as late as a call of GSSC; "": nobody
;;; asked for it
(defun $gs__take_pair (pair angle)
  (gs-declare-new (cdr pair))
  (let ((delay (+ 40 (gs-delay angle))))
    (gs-list (mapcar #'(lambda (s)
                         (if (eq s '$idle) ""
                             (let ((n (gs-target s))) (gs-give s n delay) n)))
                     (cdr pair)))))
(defun $gs__open_block (heading) (gs-open-block heading))

;;; [sine, cosine] of an angle by one call; $idle: what nobody asked for
(defun gs-sine-call (pair angle)
  (gs-declare-new (cdr pair))
  (let ((names (mapcar #'gs-target (cdr pair))) (text ($gs__sum_text angle)))
    ($gs__push (gs-said '$statement (gs-said '$sines text (car names) (cadr names))))
    (let ((delay (+ 40 (gs-delay angle))))
      (mapc #'(lambda (s n) (gs-give s n delay)) (cdr pair) names))))

;;; ------------------------------------------------------------------------------- long statements

(defun gs-assign-long (target e)
  (if (gs-sum-p e) (gs-assign-sum target e) ($gs__assign target (gs-shortened e))))

;;; length of an expression as text
(defun gs-text-length (e) (length ($gs__sum_text e)))

;;; a new symbol whose variable holds the expression
(defun gs-part (e)
  (let* ((k (incf $gs__parts)) (s ($concat '$gs__part_ k))
         (n ($gs__fresh (gs-text "PART" (format nil "~d" k)))))
    ($gs__own_name n)
    ($gs__assign (gs-opened n t) e)
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

;;; a partial sum, as several statements where one would need too many lines
(defun gs-push-sum (target so-far terms)
  (let ((lines (gs-partial-sum target so-far terms)) (n (length terms)))
    (if (or (gs-fits-p lines) (= n 1)) ($gs__push lines)
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
