;;; fortran/raw.lisp: the words of statements that are given as text.
(in-package :maxima)

(defun gs-word-char-p (c) (or (alphanumericp c) (char= c #\_)))

;;; the character of a text at a place, a blank behind its end
(declaim (inline gs-char-at))
(defun gs-char-at (s k) (if (< k (length s)) (char s k) #\Space))

;;; the first place from k on where the text has no character that `goes-on` takes
(defun gs-run-end (s k goes-on)
  (or (position-if-not goes-on s :start (min k (length s))) (length s)))

;;; one past the number that begins at k: 1, 1.5, .5D-3, but of 1.EQ.2 the 1 alone
(defun gs-number-end (s k)
  (flet ((at (e) (gs-char-at s e)))
    (loop while (or (digit-char-p (at k))
                    (and (char= (at k) #\.)
                         (or (not (alpha-char-p (at (1+ k))))
                             (and (find (at (1+ k)) "DE") (not (alpha-char-p (at (+ k 2))))))))
          do (incf k))
    (if (find (at k) "DE") (gs-run-end s (+ k 2) #'digit-char-p) k)))

;;; one past the token that begins at k with c
(defun gs-token-end (s k c)
  (cond ((alpha-char-p c) (gs-run-end s k #'gs-word-char-p))
        ((digit-char-p c) (gs-number-end s k))
        ((and (char= c #\*) (char= (gs-char-at s (1+ k)) #\*)) (+ k 2))
        ((char= c #\.) (1+ (or (position #\. s :start (1+ k)) (1- (length s)))))
        (t (1+ k))))

;;; gs__tokens(text): names, numbers, operators of a text of Fortran, in capitals
(defun $gs__tokens (text)
  (let ((s (string-upcase text)) (k 0) (tokens nil))
    (loop while (< k (length s))
          do (let* ((c (char s k)) (e (gs-token-end s k c)))
               (unless (char= c #\Space) (push (subseq s k e) tokens))
               (setq k e)))
    (gs-list (nreverse tokens))))

;;; gs__array_of("M(2,1)") => "M"
(defun $gs__array_of (place) (string-upcase (subseq place 0 (position #\( place))))

;;; The names of a text of Fortran, in capitals, in their order; neither the D of 1.0D-11 nor the GE
;;; of .GE. is one.
(defvar *gs-dotted-words*
  '(".GE." ".GT." ".LE." ".LT." ".EQ." ".NE." ".AND." ".OR." ".NOT." ".TRUE." ".FALSE."))
(defun gs-dotted-word-at (s k)
  (flet ((there-p (w)
           (let ((e (+ k (length w)))) (and (<= e (length s)) (string= w s :start2 k :end2 e)))))
    (find-if #'there-p *gs-dotted-words*)))
(defun $gs__identifiers (text)
  (let ((s (string-upcase text)) (k 0) (names nil))
    (loop while (< k (length s))
          do (let* ((c (char s k)) (dotted (and (char= c #\.) (gs-dotted-word-at s k))))
               (cond (dotted (incf k (length dotted)))
                     ((alpha-char-p c)
                      (let ((e (gs-run-end s k #'gs-word-char-p)))
                        (push (subseq s k e) names)
                        (setq k e)))
                     ((or (digit-char-p c) (char= c #\.)) (setq k (gs-past-digits s k)))
                     (t (incf k)))))
    (gs-list (nreverse names))))
;;; a table of the names that texts use
(defun $gs__names_in (texts)
  (let ((h ($gs__new_hash)))
    (dolist (text (cdr texts) h)
      (dolist (name (cdr ($gs__identifiers text))) (setf (gethash name h) t)))))
;;; one past what begins as a number does, with its letters, at k
(defun gs-past-digits (s k)
  (loop
    (incf k)
    (when (or (>= k (length s)) (gs-dotted-word-at s k)
              (not (or (char= (char s k) #\.) (alphanumericp (char s k)))))
      (return k))))

;;; -------------------------------------------------------------------------------------- counting

(defun gs-word-p (word) (and word (alpha-char-p (char word 0))))
(defun gs-digits-p (word) (and word (digit-char-p (char word 0))))
(defun gs-is-word (word text) (and word (string= word text)))

;;; the tokens behind the = of an assignment, else none
(defun $gs__right_side (tokens) (gs-list (gs-right-side (cdr tokens))))
(defun gs-right-side (l)
  (when (and (cdr l) (gs-digits-p (car l))) (pop l))
  (when (and (cddr l) (gs-word-p (car l)))
    (pop l)
    (when (gs-is-word (car l) "(") (setq l (gs-past-parenthesis l)))
    (when (and (cdr l) (gs-is-word (car l) "=")) (cdr l))))

;;; the tokens behind the parenthesis that the first one opens
(defun $gs__past_parenthesis (tokens) (gs-list (gs-past-parenthesis (cdr tokens))))
(defun gs-past-parenthesis (l)
  (let ((depth 0))
    (loop
      (let ((word (pop l)))
        (cond ((gs-is-word word "(") (incf depth)) ((gs-is-word word ")") (decf depth)))
        (when (or (zerop depth) (null l)) (return l))))))

(defvar *gs-free-calls* '("ABS" "SIGN" "MAX" "MIN" "ANINT" "GSFLR"))
(defvar *gs-trig-calls*
  '("SIN" "COS" "TAN" "ASIN" "ACOS" "ATAN" "ATAN2" "SINH" "COSH" "TANH" "LOG" "EXP"))
(defun gs-among (word words) (member word words :test #'string=))

;;; [mul, add, div, sqrt, trig] of the tokens of an expression; subscripts do not count
(defun $gs__tokens_count (tokens)
  (let ((l (cdr tokens)) (n (list 0 0 0 0 0)) (before "="))
    (flet ((count-one (k &optional (times 1)) (incf (nth k n) times)))
      (loop while l
            do (let* ((c (pop l)) (call (and (gs-word-p c) (gs-is-word (car l) "("))))
                 (cond ((string= c "*") (count-one 0))
                       ((string= c "/") (count-one 2))
                       ((and (gs-among c '("+" "-")) (not (gs-among before '("=" "(" ","))))
                        (count-one 1))
                       ((string= c "**")
                        (if (and (gs-digits-p (car l)) (not (find #\. (car l))))
                            (count-one 0 (1- (parse-integer (car l))))
                            (count-one 4)))
                       ((not call))
                       ((string= c "SQRT") (count-one 3))
                       ((gs-among c *gs-trig-calls*) (count-one 4))
                       ((not (gs-among c *gs-free-calls*)) (setq l (gs-past-parenthesis l))))
                 (setq before c))))
    (gs-list n)))

;;; Adds the operations of the assignments among statements given as text to the tally.
(defun $gs__count_raw (statements)
  (dolist (s (cdr statements))
    (let ((text (string-left-trim " " s)))
      (unless (or (string= text "") (char= (char text 0) #\!))
        ($gs__set_tally
          (gs-list (mapcar #'+ (cdr ($gs__tally))
                           (cdr ($gs__tokens_count ($gs__right_side ($gs__tokens s)))))))))))

;;; ----------------------------------------------------------------------------------------- lines

;;; the lines of statements given as text, see gs__routine
(defun $gs__raw (statements) (gs-list (loop for s in (cdr statements) append (gs-raw-lines s))))
(defun $gs__raw_lines (s) (gs-list (gs-raw-lines s)))
(defun gs-raw-lines (s)
  (let* ((text (string-left-trim " " s)) (indent (- (length s) (length text)))
         (k (or (position-if-not #'digit-char-p text) (length text))))
    (cond ((string= text "") (list "C"))
          ((char= (char text 0) #\!)
           (cdr ($gs__filled (subseq text 1) "C     " "C     ")))
          ((eql 0 (search "C$" text)) (list text))
          ((zerop k) (cdr (mfuncall '$gs__statement_lines text "" indent)))
          (t (cdr (mfuncall '$gs__statement_lines (string-left-trim " " (subseq text k))
                            (format nil "~5@a" (subseq text 0 k)) 0))))))
