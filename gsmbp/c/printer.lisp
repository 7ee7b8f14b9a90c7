;;; c/printer.lisp: what C99 has to say for itself (text/language.lisp).
(in-package :maxima)

;;; functions whose name in C is not that of Fortran in small letters
(defvar *gs-c-functions*
  '(("ABS" . "fabs") ("MAX" . "gs_max") ("MIN" . "gs_min") ("ANINT" . "round")
    ("SIGN" . "copysign") ("GSFLR" . "gsflr")))

(defun gs-c-call (name texts)
  (let ((f (or (cdr (assoc name *gs-c-functions* :test #'string=)) (string-downcase name))))
    (cond ((string= name "SIGN") (gs-text f " (1.0, " (car texts) ")"))
          ((member name '("MAX" "MIN") :test #'string=) (gs-c-nested f texts))
          (t (gs-text f " (" (gs-joined texts ", ") ")")))))
;;; f(f(a, b), c)
(defun gs-c-nested (f texts)
  (let ((so-far (car texts)))
    (dolist (x (cdr texts) so-far) (setq so-far (gs-text f " (" so-far ", " x ")")))))

;;; b^n as a factor: products as gfortran forms them (its table of addition chains), of a variable
;;; written out, else by the functions of gsmbp/powers.h
(defun gs-c-power (b n)
  (if (and (symbolp b) (<= n 3))
      (let ((x (gs-name-text b)))
        (if (= n 2) (gs-text "(" x "*" x ")") (gs-text "(" x "*" x "*" x ")")))
      (gs-text "gs_power" (format nil "~d" n) " (" ($gs__sum_text b) ")")))

;;; "(x*x)" at the left end of a product needs no parentheses
(defun gs-c-above (text)
  (if (and (eql (char text 0) #\() (every #'(lambda (c) (or (gs-word-character-p c) (find c "(*)")))
                                          text)
           (= 1 (count #\( text)) (= 1 (count #\) text)) (eql (char text (1- (length text))) #\)))
      (subseq text 1 (1- (length text)))
      text))

(defun gs-c-assignment (target pieces own)
  (gs-c-packed (cons (gs-text (if own "const double " "") target " = " (cadr pieces))
                     (append (cddr pieces) (list ";")))))

;;; a statement given in pieces as lines of at most 98 characters
(defun gs-c-packed (pieces)
  (gs-c-lines (gs-joined pieces "") "  "))
;;; the text of a statement as lines, `indent` ahead, broken between tokens
(defun $gs__c_lines (text indent) (gs-c-lines text indent))
(defun $gs__c_comment (text indent) (gs-c-comment text indent))
(defun gs-c-lines (text indent)
  (let ((lines nil) (lead indent) (start 0) (size (length text)))
    (loop
      (let ((end (+ start (- 98 (length lead)))))
        (when (>= end size)
          (push (gs-text lead (subseq text start)) lines)
          (return (gs-list (nreverse lines))))
        (let ((cut (gs-c-break text start end)))
          (push (string-right-trim " " (gs-text lead (subseq text start cut))) lines)
          (setq start (if (char= (char text cut) #\Space) (1+ cut) cut)
                lead (gs-text indent "    ")))))))
;;; where the next line may begin: at most at end
(defun gs-c-break (text start end)
  (or (loop for k from end above (+ start 40)
            when (and (char= (char text k) #\Space)
                      (find (char text (1+ k)) "+-&|")
                      (char= (char text (+ k 2)) #\Space))
              return k)
      (loop for k from end above start
            when (or (and (char= (char text k) #\Space)
                          (not (find (char text (1- k)) "+-")))
                     (and (find (char text k) "*/") (< k end)))
              return k)
      end))

(defun gs-c-sines (angle names own)
  (let ((call (gs-c-lines (gs-text "gs_sines (" angle ", &" (car names) ", &" (cadr names) ");")
                          "  ")))
    (if own (gs-list (cons (gs-text "  double " (gs-joined own ", ") ";") (cdr call))) call)))

(gs-set-printer '$c
  :cased #'string-downcase
  :base #'(lambda (text) (string-downcase (gs-plain-name text)))
  :constant #'(lambda (n k) ($gs__decimal_text n k "e"))
  :power #'gs-c-power
  :general #'(lambda (b n) (gs-text "pow (" ($gs__sum_text b) ", " ($gs__sum_text n) ")"))
  :root #'(lambda (b) (gs-text "sqrt (" ($gs__sum_text b) ")"))
  :exponential #'(lambda (n) (gs-text "exp (" ($gs__sum_text n) ")"))
  :call #'gs-c-call
  :above #'gs-c-above
  :load #'(lambda (name source) (gs-text "  const double " name " = " source ";"))
  :assign #'gs-c-assignment
  :most #'(lambda () nil)
  :sines #'gs-c-sines
  :block #'(lambda (heading) (gs-c-comment heading "  "))
  :given #'(lambda (text) (gs-c-lines text "  ")))

;;; a comment of its own, filled
(defun gs-c-comment (text indent)
  (let ((lines (cdr ($gs__filled_to text (gs-text indent "/* ") (gs-text indent "   ") 95))))
    (gs-list (append (butlast lines) (list (gs-text (car (last lines)) " */"))))))

;;; the words that lines hold, as a table
(defun $gs__words_in (lines)
  (let ((words (make-hash-table :test #'equal)))
    (dolist (l (cdr lines) words)
      (let ((start nil))
        (dotimes (k (1+ (length l)))
          (let ((in (and (< k (length l)) (gs-word-character-p (char l k)))))
            (cond ((and in (null start)) (setq start k))
                  ((and start (not in))
                   (setf (gethash (subseq l start k) words) t start nil)))))))))
