;;; show/texinfo.lisp: plain words in Texinfo.
(in-package :maxima)

;;; the text with @ { } escaped; false where it holds what is no printable character of ASCII
(defun $gs__texinfo_escaped (text)
  (and (every #'(lambda (c) (<= 32 (char-code c) 126)) text)
       (with-output-to-string (s)
         (loop for c across text
               do (when (find c "@{}") (write-char #\@ s))
                  (write-char c s)))))
