;;; fortran/json.lisp: values as JSON text: strings, decimals, pairs.
(in-package :maxima)

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
