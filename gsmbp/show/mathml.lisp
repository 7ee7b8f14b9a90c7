;;; show/mathml.lisp: MathML Core of the TeX that show/pretty.mac and show/document.mac write, and
;;; text as HTML holds it. The TeX is one of few commands: fractions, roots, dots, sub- and
;;; superscripts, names, functions, Greek letters; anything else is shown as the characters it is.
;;;
;;; A node is (text . kind), kind one of operand, fenced (in parentheses), function, operator,
;;; space; a row is a list of them.
(in-package :maxima)

;;; ------------------------------------------------------------------------------------------- text

;;; a text as HTML and XML show it; control characters are no characters there
(defun $gs__html_text (s)
  (with-output-to-string (o)
    (map nil
         #'(lambda (c)
             (let ((special (assoc c '((#\& . "&amp;") (#\< . "&lt;") (#\> . "&gt;")
                                       (#\" . "&quot;") (#\' . "&#39;")))))
               (cond (special (write-string (cdr special) o))
                     ((and (< (char-code c) 32) (not (member (char-code c) '(9 10 13)))))
                     (t (write-char c o)))))
         s)))

;;; --------------------------------------------------------------------------------------- reading

(defvar *gs-tex* "")                   ; the TeX that is read, and the place in it
(defvar *gs-place* 0)

(defun gs-tex-peek (&optional (ahead 0))
  (let ((k (+ *gs-place* ahead))) (and (< k (length *gs-tex*)) (char *gs-tex* k))))
(defun gs-tex-next () (prog1 (gs-tex-peek) (incf *gs-place*)))
(defun gs-tex-blanks ()
  (loop while (eql (gs-tex-peek) #\Space) do (incf *gs-place*)))

;;; the characters from here on that fulfil a test
(defun gs-tex-run (test)
  (let ((start *gs-place*))
    (loop while (and (gs-tex-peek) (funcall test (gs-tex-peek))) do (incf *gs-place*))
    (subseq *gs-tex* start (min *gs-place* (length *gs-tex*)))))
(defun gs-tex-letter-p (c) (or (char<= #\a c #\z) (char<= #\A c #\Z)))
(defun gs-tex-foreign-p (c) (> (char-code c) 127))
(defun gs-tex-number-p (c) (or (char<= #\0 c #\9) (char= c #\.)))

;;; the words of a group {...} as they are: \_ is _, \textbackslash a backslash, $<$ is <
(defun gs-tex-words ()
  (gs-tex-blanks)
  (if (eql (gs-tex-peek) #\{) (incf *gs-place*))
  (with-output-to-string (o)
    (loop for c = (gs-tex-next)
          until (member c '(nil #\}))
          do (cond ((char= c #\\) (write-string (gs-tex-escaped) o))
                   ((char/= c #\$) (write-char c o))))))
;;; behind a backslash in words
(defun gs-tex-escaped ()
  (let ((word (gs-tex-run #'gs-tex-letter-p)))
    (cond ((string= word "textbackslash") (gs-tex-blanks) "\\")
          ((string/= word "") word)
          ((null (gs-tex-peek)) "\\")
          (t (let ((c (gs-tex-next)))
               (if (and (member c '(#\^ #\~)) (eql (gs-tex-peek) #\{) (eql (gs-tex-peek 1) #\}))
                   (incf *gs-place* 2))
               (string c))))))

;;; ----------------------------------------------------------------------------------------- nodes

(defun gs-element (name &rest inner)
  (gs-text "<" name ">" (gs-joined inner "") "</" name ">"))
(defun gs-operand (name &rest inner) (cons (apply #'gs-element name inner) 'operand))
(defun gs-operator (text) (cons (gs-element "mo" text) 'operator))
(defun gs-name-node (text) (gs-operand "mi" ($gs__html_text text)))
;;; a name of several letters is slanted by the page's style, as one letter is by itself
(defun gs-slanted (text)
  (if (= (length text) 1)
      (gs-name-node text)
      (cons (gs-text "<mi class=\"it\">" ($gs__html_text text) "</mi>") 'operand)))
(defun gs-upright (text)
  (cons (gs-text "<mi mathvariant=\"normal\">" ($gs__html_text text) "</mi>") 'operand))
(defun gs-space-node (width) (cons (gs-text "<mspace width=\"" width "\"></mspace>") 'space))
(defun gs-function-node (text) (cons (gs-element "mi" ($gs__html_text text)) 'function))

;;; the text of a row; two operands side by side are a product (without a gap ahead of a
;;; parenthesis), a function is applied to what follows
(defun gs-row-text (row)
  (with-output-to-string (o)
    (loop for (node . more) on row
          do (write-string (car node) o)
             (case (cdr node)
               (function (if more (write-string "<mo>&#x2061;</mo>" o)))
               ((operand fenced)
                 (if (and more (member (cdar more) '(operand function)))
                     (write-string "<mo rspace=\"0.15em\">&#x2062;</mo>" o)))))))
;;; a row as one element
(defun gs-row-element (row)
  (if (= (length row) 1) (caar row) (gs-element "mrow" (gs-row-text row))))
(defun gs-one-element (row) (cons (gs-row-element row) 'operand))

;;; ---------------------------------------------------------------------------------------- grammar

;;; the row up to the character `end` (nil: the end of the text), which is not taken; names of
;;; several letters are whole in an index
(defun gs-tex-row (end index)
  (let ((row nil))
    (loop (gs-tex-blanks)
          (let ((c (gs-tex-peek)))
            (cond ((or (null c) (eql c end) (eql c #\})) (return (nreverse row)))
                  ((member c '(#\_ #\^))
                   (push (gs-tex-scripts (or (pop row) (gs-operand "mrow"))) row))
                  ((eql c #\() (setq row (append (reverse (gs-tex-parentheses index)) row)))
                  (t (let ((node (gs-tex-node c index))) (if node (push node row)))))))))

;;; base with what stands below and above it
(defun gs-tex-scripts (base)
  (let ((below nil) (above nil))
    (loop (gs-tex-blanks)
          (case (gs-tex-peek)
            (#\_ (incf *gs-place*) (setq below (gs-row-element (gs-tex-argument t))))
            (#\^ (incf *gs-place*) (setq above (gs-row-element (gs-tex-argument nil))))
            (t (return))))
    (cons (cond ((and below above) (gs-element "msubsup" (car base) below above))
                (below (gs-element "msub" (car base) below))
                (t (gs-element "msup" (car base) above)))
          (cdr base))))

;;; the argument of a command: a group, or one node
(defun gs-tex-argument (index)
  (gs-tex-blanks)
  (cond ((null (gs-tex-peek)) nil)
        ((eql (gs-tex-peek) #\{)
         (incf *gs-place*)
         (prog1 (gs-tex-row #\} index) (incf *gs-place*)))
        (t (let ((node (gs-tex-node (gs-tex-peek) index))) (and node (list node))))))

;;; (...) as one operand that grows with what is in it; of a line that is broken within, the rest as
;;; it stands
(defun gs-tex-parentheses (index)
  (incf *gs-place*)
  (let ((inner (gs-tex-row #\) index)))
    (cond ((eql (gs-tex-peek) #\))
           (incf *gs-place*)
           (list (cons (gs-element "mrow" "<mo>(</mo>" (gs-row-text inner) "<mo>)</mo>")
                       'fenced)))
          (t (cons (gs-fixed-fence "(") inner)))))
(defun gs-fixed-fence (text)
  (cons (gs-text "<mo stretchy=\"false\">" text "</mo>") 'operator))

;;; one node that begins with the character c, or nil
(defun gs-tex-node (c index)
  (cond ((eql c #\\) (incf *gs-place*) (gs-tex-command))
        ((eql c #\{) (gs-one-element (gs-tex-argument index)))
        ((gs-tex-number-p c) (gs-operand "mn" (gs-tex-run #'gs-tex-number-p)))
        ((gs-tex-letter-p c)
         (gs-slanted (if index (gs-tex-run #'gs-tex-letter-p) (string (gs-tex-next)))))
        ((gs-tex-foreign-p c) (gs-name-node (gs-tex-run #'gs-tex-foreign-p)))
        (t (incf *gs-place*) (gs-tex-sign c))))
(defun gs-tex-sign (c)
  (case c
    (#\- (gs-operator "&#x2212;"))
    (#\' (gs-operator "&#x2032;"))
    ((#\( #\) #\[ #\] #\|) (gs-fixed-fence (string c)))
    (#\~ (gs-space-node "0.33em"))
    ((#\$ #\&) nil)
    (t (gs-operator ($gs__html_text (string c))))))

(defvar *gs-tex-functions* '("sin" "cos" "tan" "sinh" "cosh" "tanh" "ln" "exp" "log"))
(defvar *gs-tex-signs* '(("cdot" . "&#x22C5;") ("partial" . "&#x2202;")))
(defvar *gs-tex-spaces* '(("quad" . "1em") ("qquad" . "2em") ("allowbreak" . "0em")))
(defvar *gs-tex-greek*
  '(("alpha" . 945) ("beta" . 946) ("gamma" . 947) ("delta" . 948) ("epsilon" . 949) ("zeta" . 950)
    ("eta" . 951) ("theta" . 952) ("kappa" . 954) ("lambda" . 955) ("mu" . 956) ("nu" . 957)
    ("xi" . 958) ("pi" . 960) ("rho" . 961) ("sigma" . 963) ("tau" . 964) ("phi" . 966)
    ("chi" . 967) ("psi" . 968) ("omega" . 969) ("Gamma" . 915) ("Delta" . 916) ("Theta" . 920)
    ("Lambda" . 923) ("Xi" . 926) ("Pi" . 928) ("Sigma" . 931) ("Phi" . 934) ("Psi" . 936)
    ("Omega" . 937)))
(defun gs-tex-known (word table) (cdr (assoc word table :test #'string=)))

;;; the node of a command, from behind its backslash
(defun gs-tex-command ()
  (let* ((word (gs-tex-run #'gs-tex-letter-p)) (code (gs-tex-known word *gs-tex-greek*))
         (sign (gs-tex-known word *gs-tex-signs*)) (space (gs-tex-known word *gs-tex-spaces*)))
    (cond ((string= word "") (gs-tex-escaped-node))
          (code (gs-operand "mi" (format nil "&#~d;" code)))
          (sign (gs-operator sign))
          (space (gs-space-node space))
          ((member word *gs-tex-functions* :test #'string=) (gs-function-node word))
          (t (gs-tex-build word)))))
(defun gs-tex-escaped-node ()
  (let ((c (gs-tex-next)))
    (case c
      ((nil) nil)
      ((#\Space #\,) (gs-space-node "0.17em"))
      (t (gs-operator ($gs__html_text (string c)))))))

;;; commands with arguments
(defun gs-tex-build (word)
  (flet ((is (name) (string= word name)) (argument () (gs-row-element (gs-tex-argument nil))))
    (cond ((or (is "frac") (is "tfrac"))
           (let ((above (argument))) (gs-operand "mfrac" above (argument))))
          ((is "sqrt") (gs-operand "msqrt" (argument)))
          ((is "dot") (gs-dotted (gs-tex-argument nil) "&#x2D9;"))
          ((is "ddot") (gs-dotted (gs-tex-argument nil) "&#xA8;"))
          ((is "mathit") (gs-slanted (gs-tex-words)))
          ((is "mathrm") (gs-upright (gs-tex-words)))
          ((is "operatorname") (gs-function-node (gs-tex-words)))
          ((is "text") (gs-operand "mtext" ($gs__html_text (gs-tex-words))))
          (t (gs-upright word)))))
(defun gs-dotted (row dots)
  (gs-operand "mover" (gs-row-element row) (gs-text "<mo>" dots "</mo>")))

;;; ------------------------------------------------------------------------------------- for Maxima

;;; the MathML of a text in TeX, as what stands inside <math>; a `)` that nothing opened stands for
;;; itself
(defun gs-mathml (tex)
  (let ((*gs-tex* tex) (*gs-place* 0) (row nil))
    (loop (setq row (append row (gs-tex-row nil nil)))
          (if (gs-tex-peek) (incf *gs-place*) (return (gs-row-text row))))))
(defun $gs__mathml_inner (tex) (gs-mathml tex))

;;; a line "left &= right" of an alignment as a row of a table
(defun $gs__mathml_line (line)
  (let ((k (position-if #'(lambda (i) (and (char= (char line i) #\&)
                                           (not (and (> i 0) (char= (char line (1- i)) #\\)))))
                        (loop for i below (length line) collect i))))
    (gs-text "<mtr><mtd>" (gs-mathml (if k (subseq line 0 k) "")) "</mtd><mtd>"
             (gs-mathml (subseq line (if k (1+ k) 0))) "</mtd></mtr>")))
