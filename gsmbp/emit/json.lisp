;;; emit/json.lisp: values as JSON text: strings, decimals, pairs.
(in-package :maxima)

;;; a string in quotes; quote, backslash and control characters escaped
(defun $gs__json_string (s)
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
(defun $gs__json_inline (v)
  (cond ((stringp v) ($gs__json_string v))
        ((null v) "false")
        ((eq v t) "true")
        ((and (symbolp v) (not ($constantp v))) ($gs__json_string ($sconcat v)))
        (($gs__json_objectp v)
         (gs-text "{" (gs-joined (mapcar #'gs-json-pair (cdr v)) ", ") "}"))
        (($listp v) (gs-text "[" (gs-joined (mapcar #'$gs__json_inline (cdr v)) ", ") "]"))
        (t (or (gs-json-decimal v) (mfuncall '$gs__json_number v)))))

;;; a number that is a short integer or decimal fraction, else nil
(defun gs-json-decimal (v)
  (cond ((integerp v) (and (< (abs v) (expt 10 16)) (format nil "~d" v)))
        ((ratnump v)
         (let ((d ($gs__finite_decimal (gs-magnitude v))))
           (and d
                (< (cadr d) (expt 10 20))
                (gs-text
                  (if (gs-negative-p v) "-" "")
                  ($gs__decimal_text (cadr d) (caddr d) "e")))))))

(defun gs-json-key (e) (gs-text ($gs__json_string ($sconcat (cadr e))) ": "))

(defun gs-json-pair (e) (gs-text (gs-json-key e) ($gs__json_inline (caddr e))))

(defun $gs__json_objectp (v)
  (and (consp v)
       (or (and (eq (caar v) '$set) (null (cdr v)))
           (and ($listp v)
                (cdr v)
                (loop for e in (cdr v) always (and (consp e) (eq (caar e) 'mequal)))))))

;;; the lines of v: `lead` (a key) ahead of it, `tail` (a comma) behind it
(defun $gs__json_block (indent v lead tail) (gs-list (gs-json-lines indent v lead tail)))

(defun gs-json-lines (indent v lead tail)
  (let* ((object ($gs__json_objectp v)) (parts (and (or object ($listp v)) (cdr v)))
         (text (if (or (null parts) (string/= indent ""))
                   (gs-text indent lead ($gs__json_inline v) tail))))
    (if (and text (or (null parts) (<= (length text) 150)))
        (list text)
        (let ((lines (list (gs-text indent lead (if object "{" "["))))
              (inner (gs-text indent "  ")))
          (do ((l parts (cdr l)))
              ((null l))
            (setq lines
                  (revappend
                    (gs-json-lines
                      inner (if object (caddr (car l)) (car l))
                      (if object (gs-json-key (car l)) "") (if (cdr l) "," "")) lines)))
          (reverse (cons (gs-text indent (if object "}" "]") tail) lines))))))
