;;; robots/xml.lisp: XML as lists, by share/urdf/read; decimals as they are typed in a file.
(in-package :maxima)

;;; The elements of an XML file: [tag, line, [[attribute, value], ...], [child, ...]], or a string:
;;; what is wrong, with its line. `reader` is the program, `folder` a name that no file has.
(defun $gs__xml_elements (reader file folder)
  (let ((list (concatenate 'string folder "/list")))
    (mfuncall '$system
              (format nil "sh ~a ~a ~a" (gs-shell-word reader) (gs-shell-word file)
                      (gs-shell-word folder)))
    (if (probe-file list)
        (let ((tree (gs-read-list list)))
          (delete-file list)
          (mfuncall '$system (format nil "rmdir ~a" (gs-shell-word folder)))
          (cond ((not (and (consp tree) (stringp (if (eq (car tree) :error) (caddr tree) (car tree)))))
                 "the file cannot be parsed")
                ((eq (car tree) :error)
                 (format nil "~:[line ~a: ~;~*~]~a" (eql (cadr tree) 0) (cadr tree) (caddr tree)))
                (t (gs-xml-node tree))))
        "the reader of XML (share/urdf/read) cannot be run")))

(defun $gs__new_folder (above)
  (format nil "~a/gsmbp-~d-~d" above (get-universal-time)
          (random 1000000000 (make-random-state t))))

(defun gs-shell-word (s)
  (with-output-to-string (out)
    (write-char #\' out)
    (loop for c across s do (if (char= c #\') (write-string "'\\''" out) (write-char c out)))
    (write-char #\' out)))

(defun gs-read-list (file)
  (with-open-file (in file)
    (let ((*read-eval* nil) (*readtable* (copy-readtable nil)) (*read-base* 10))
      (read in nil nil))))

(defun gs-xml-node (node)
  (destructuring-bind (tag line attributes children) node
    (list '(mlist simp) tag line
          (cons '(mlist simp)
                (mapcar #'(lambda (a) (list '(mlist simp) (car a) (cdr a))) attributes))
          (cons '(mlist simp) (mapcar #'gs-xml-node children)))))

;;; The number of a text such as -1.5e-3, exact; false if it is none, or beyond what a double holds.
(defun $gs__typed_number (s)
  (let ((i 0) (n (length s)) (sign 1) (digits 0) (mantissa 0) (places 0) (power 0) (down 1))
    (flet ((sign-here ()
             (let ((c (and (< i n) (char s i))))
               (when (member c '(#\+ #\-)) (incf i))
               (if (eql c #\-) -1 1)))
           (digit-here () (and (< i n) (digit-char-p (char s i)))))
      (setq sign (sign-here))
      (loop while (digit-here)
            do (setq mantissa (+ (* 10 mantissa) (digit-here))) (incf digits) (incf i))
      (when (and (< i n) (char= (char s i) #\.))
        (incf i)
        (loop while (digit-here)
              do (setq mantissa (+ (* 10 mantissa) (digit-here)))
                 (incf digits) (incf places) (incf i)))
      (when (and (< i n) (plusp digits) (char-equal (char s i) #\e))
        (incf i)
        (setq down (sign-here))
        (unless (digit-here) (return-from $gs__typed_number nil))
        (loop while (digit-here)
              do (when (< power 100000) (setq power (+ (* 10 power) (digit-here)))) (incf i)))
      (if (or (zerop digits) (< i n) (> digits 400) (> power 700))
          nil
          (let ((r (* sign mantissa (expt 10 (- (* down power) places)))))
            (cond ((> (abs r) (expt 10 300)) nil)
                  ((integerp r) r)
                  (t (list '(rat simp) (numerator r) (denominator r)))))))))

;;; the words of a text, apart by blanks, tabs or ends of lines
(defun $gs__blank_words (s)
  (let ((words nil) (word nil))
    (flet ((end () (when word (push (coerce (nreverse word) 'string) words) (setq word nil))))
      (loop for c across s
            do (if (member c '(#\Space #\Tab #\Newline #\Return)) (end) (push c word)))
      (end)
      (cons '(mlist simp) (nreverse words)))))

;;; An exact number as it would be typed: 0.02, 1.5e-7; of more digits than a double has, a fraction.
(defun $gs__typed_text (r)
  (let* ((q (gs-rational r)) (d ($gs__finite_decimal_or_false (abs q))))
    (cond ((zerop q) "0")
          ((integerp q) (format nil "~d" q))
          ((null d) (format nil "~d/~d" (numerator q) (denominator q)))
          (t (concatenate 'string (if (minusp q) "-" "") (gs-decimal-text (car d) (cdr d)))))))
(defun $gs__finite_decimal_or_false (q)
  (and (plusp q)
       (let ((d ($gs__finite_decimal
                  (if (integerp q) q (list '(rat simp) (numerator q) (denominator q))))))
         (and (consp d) (cons (cadr d) (caddr d))))))
;;; n/10^k
(defun gs-decimal-text (n k)
  (let* ((digits (format nil "~d" n)) (many (length digits)))
    (cond ((> many 17) (format nil "~d/10^~d" n k))
          ((<= many (- k 4))
           (format nil "~a~:[.~a~;~*~]e-~d" (char digits 0) (= many 1) (subseq digits 1)
                   (- k (1- many))))
          ((<= many k)
           (format nil "0.~a~a" (make-string (- k many) :initial-element #\0) digits))
          (t (format nil "~a.~a" (subseq digits 0 (- many k)) (subseq digits (- many k)))))))

;;; whether Maxima would take the name for something of its own: a word of its grammar, a variable
;;; of its own that has a value, a constant
(defun $gs__is_maximas (text)
  (let ((s ($gs__symbol_of text)))
    (and (or (and (boundp s) (not (member s (cdr $values))))
             (get s 'op) (get s 'nud) (get s 'led) (get s 'sysconst) (kindp s '$constant))
         t)))
(defun $gs__symbol_of (text) (intern (concatenate 'string "$" (maybe-invert-string-case text)) :maxima))
