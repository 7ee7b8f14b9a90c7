;;; kernel/session.lisp: every public function runs in an environment of its own: the options of
;;; Maxima have their first values, facts that were assumed and properties that were declared do not
;;; hold. The session is afterwards as it was, also after an error. What cannot be put aside, rules
;;; on the operators of arithmetic and an order of symbols, is an error.
(in-package :maxima)

;;; ---------------------------------------------------------------------------------------- options

;;; Options that say nothing about expressions and stay the user's: what is shown and where, where
;;; files are, what Maxima notes down.
(defvar *gs-kept-options*
  '($_ $__ $% $%% $piece $askexp $linenum $labels tr-unique $values $infolists $aliases $features
       $myoptions $notes $functions $macros $arrays $props $structures $rules $gradefs $dependencies
       $let_rule_packages $current_let_rule_package $default_let_rule_package $context $contexts
       $activecontexts $error $error_syms $error_size $errormsg $debugmode $backtrace $display2d
       $linel $ttyoff $showtime $prompt $inchar $linechar $outchar $leftjust $announce_rules_firing
       $setcheck $optionset $ratprint $setcheckbreak $refcheck $storenum $disptime $timer $trace
       $tempdir $logfile))
(defvar *gs-kept-stems*
  '("$FILE" "$MAXIMA_" "$LOAD" "$GNUPLOT" "$PLOT" "$TESTSUITE" "$SHARE_TESTSUITE" "$TRACE" "$TIMER"
            "$GSMBP" "$TTY" "$IN_NETMATH" "$DRAW"))

(defun gs-kept-p (s)
  (or (member s *gs-kept-options* :test #'eq)
      (let ((name (symbol-name s)))
        (or ; variables of Maxima's own
            (not (or (find (char name 0) "$%") (eq s 'modulus)))
            (some #'(lambda (stem)
                      (and (<= (length stem) (length name))
                           (string-equal stem name :end2 (length stem)))) *gs-kept-stems*)))))

;;; the options whose values are not those that Maxima starts with, as (names . first values);
;;; Maxima's reset() uses the same table
(defun gs-changed-options ()
  (let ((names nil) (values nil))
    (maphash
      #'(lambda (s v)
          (unless (or (not (boundp s)) (equal (symbol-value s) v) (gs-kept-p s))
            (push s names)
            (push v values)))
      *variable-initial-values*)
    (cons names values)))

;;; ------------------------------------------------------------------------------------- properties

;;; what declare, depends and gradef leave on a symbol: of its properties, of those of Maxima's own
;;; list
(defvar *gs-declared* '(bindtest evflag evfun))
(defvar *gs-declared-more*
  '($mainvar $scalar $nonscalar $constant $nonarray depends $atomgrad atvalues))

(defun gs-without (plist keys)
  (loop for (k v) on plist by #'cddr unless (member k keys :test #'eq) append (list k v)))
(defun gs-undeclared (plist)
  (let ((mprops (getf plist 'mprops)) (rest (gs-without plist (cons 'mprops *gs-declared*))))
    (if mprops
        (list* 'mprops (cons (car mprops) (gs-without (cdr mprops) *gs-declared-more*)) rest)
        rest)))

;;; the symbols to which the user has given properties, each with these
(defun gs-declared-symbols ()
  (let ((found nil))
    (flet ((note (s)
             (when (and (symbolp s)
                        (not (assoc s found))
                        (not (eql 0 (search "$GSMBP" (string-upcase (symbol-name s))))))
               (push (cons s (symbol-plist s)) found))))
      (mapc #'note (cdr $props))
      (dolist (d (cdr $dependencies)) (note (caar d))))
    found))

;;; ------------------------------------------------------------------------------------------ facts

(defun gs-facts-p ()
  (or (cdr $activecontexts)
      (some #'(lambda (c) (and (not (eq c '$global)) (cdr ($facts c)))) (cdr $contexts))))

;;; f called where no fact holds but those that Maxima begins with
(defun gs-without-facts (f)
  (if (not (gs-facts-p)) (funcall f)
    (let ((before $context) (active (cdr $activecontexts)) (own (gensym "$GSMBP__FACTS")))
      (dolist (c active) ($deactivate c))
      ($supcontext own '$global)
      (unwind-protect (funcall f)
        (mset '$context before)
        ($killcontext own)
        (dolist (c (reverse active)) ($activate c))))))

;;; ----------------------------------------------------------------------------- what is in the way

(defvar *gs-operators*
  '(mplus mtimes mexpt mminus mquotient mabs rat %sin %cos %tan %asin %acos %atan $atan2 %atan2
          %sinh %cosh %tanh %log %exp %sqrt $max $min %max %min %signum mequal mlist))

(defun gs-refuse (what)
  (mfuncall '$gs__error "gsmbp" (concatenate 'string "expected a session without " what)))
(defun gs-shown (op)
  (let ((s (or (get op 'op) (get op 'reversealias) op)))
    (if (stringp s) (format nil "\"~a\"" s) (coerce (mstring s) 'string))))

(defun gs-check-session ()
  (dolist (r (cdr $rules))
    (let ((op (mget r 'ruleof)))
      (when (member op *gs-operators* :test #'eq)
        (gs-refuse
          (format nil "rules of tellsimp on ~a; remrule(~a, all) takes ~a away" (gs-shown op)
                  (gs-shown op) (coerce (mstring r) 'string))))))
  (dolist (g (cdr $gradefs))
    (when (member (caar g) *gs-operators* :test #'eq)
      (gs-refuse (format nil "a gradef of ~a of your own" (gs-shown (caar g))))))
  (when (gs-ordered-p)
    (gs-refuse "an order of symbols by orderless or ordergreat; unorder() takes it away")))
;;; Maxima gives ordered symbols other names, _101q1
(defun gs-ordered-p ()
  (or (and (boundp 'lessorder) (symbol-value 'lessorder))
      (and (boundp 'greatorder) (symbol-value 'greatorder))
      (and (boundp '*lessorder*) (symbol-value '*lessorder*))
      (and (boundp '*greatorder*) (symbol-value '*greatorder*))))

;;; ------------------------------------------------------------------------------------- interrupts

;;; Where a public function was called from: what it calls may write into strings and files.
(defvar *gs-output* nil)

;;; Return to Maxima's prompt.
(defun gs-interrupt ()
  (let ((output (or *gs-output* *standard-output*)))
    (fresh-line output)
    (format output "gsmbp: interrupted~%"))
  (throw 'macsyma-quit 'maxima-error))

;;; f called so that Ctrl-C ends in Maxima's next prompt. The interrupt of GCL is an error like any
;;; other: errcatch, and Maxima's own handlers in charat, substring and float, would take it for a
;;; failure of what they try, and go on.
(defun gs-interruptible (f)
  #-gcl (funcall f)
  #+gcl
  (let ((before (symbol-function 'si::terminal-interrupt)))
    (unwind-protect
      (progn
        (setf (symbol-function 'si::terminal-interrupt)
              #'(lambda (&rest args) (declare (ignore args))
                  (setf (symbol-function 'si::terminal-interrupt) before)
                  (gs-interrupt)))
        (funcall f))
      (setf (symbol-function 'si::terminal-interrupt) before))))

;;; -------------------------------------------------------------------------------- the environment

(defvar *gs-apart* nil)

;;; Expressions are written as Maxima 5.46 writes them, (-a)+b and -a*b, where 5.47 writes -a+b and
;;; -(a*b): how strongly a minus binds in text is a property of mminus.
(defun gs-apart (f)
  (if *gs-apart*
      (funcall f)
      (let ((*gs-output* *standard-output*))
        (gs-interruptible #'(lambda () (gs-in-environment f))))))
(defun gs-in-environment (f)
  (let ((*gs-apart* t) ($optionset nil) (*print-base* 10) (*read-base* 10) (declared nil)
        (minus (get 'mminus 'rbp)) (mark (cons bindlist loclist))
        (changed (gs-changed-options)))
    (unwind-protect (progn
      (mbind (car changed) (cdr changed) nil)
      (gs-check-session)
      (setq declared (gs-declared-symbols))
      (dolist (d declared) (setf (symbol-plist (car d)) (gs-undeclared (cdr d))))
      (setf (get 'mminus 'rbp) 100)
      (gs-without-facts f))
      (setf (get 'mminus 'rbp) minus)
      (errlfun1 mark)
      (dolist (d declared) (setf (symbol-plist (car d)) (cdr d))))))

;;; gs__apart(e): e evaluated in that environment
(defmspec $gs__apart (form) (let ((e (cadr form))) (gs-apart #'(lambda () (meval e)))))

;;; The public functions of the package, each with its body in that environment: what is called with
;;; an expression sees it as the user gave it. They take any number of arguments, which
;;; gs__called counts.
(defun $gs__set_apart ()
  (dolist (f (cdr $functions))
    (let* ((name (caar f)) (text (string-upcase (symbol-name name))) (e (mget name 'mexpr)))
      (when (and (eql 0 (search "$GSMBP_" text)) (not (eql 0 (search "$GSMBP__" text))) e)
        (unless (and (consp (caddr e)) (eq (caar (caddr e)) '$gs__apart))
          (mputprop name e 'gs-own)
          (mputprop name
                    (list (car e)
                          '((mlist) ((mlist) $gs__given))
                          `(($gs__apart)
                            (($gs__called) ((mquote) ,name) $gs__given))) 'mexpr)))))
  '$done)

;;; The variables of the package are not among the user's `values`: kill(values) leaves them, and
;;; Maxima, which searches that list at each assignment of an interpreted function, has little to
;;; search: a derivation takes 40 % less time than with 217 variables in it.
(defun $gs__hide_values ()
  (flet ((own (s) (let ((text (string-upcase (symbol-name s))))
                    (or (eql 0 (search "$GS__" text)) (eql 0 (search "$GSMBP_" text))))))
    (setq $values (cons (car $values) (remove-if #'own (cdr $values))))))

;;; The own body of a public function on arguments that are as many as it takes, the first a scene
;;; where it is one.
(defun $gs__called (name given)
  (let* ((e (mget name 'gs-own)) (args (cdr given)) (params (cdr (cadr e)))
         (least (count-if #'atom params)))
    (when (or (< (length args) least) (and (> (length args) least) (= least (length params))))
      (gs-miscounted name params least (length args)))
    (when (eq (car params) '$scene)
      ($gs__need_scene (gs-as-written name) (car args)))
    (gs-clear-errors
      (let ((s (car args)))             ; its first field is the name
        (if ($gs__is_struct s '$gs__scene)
            (format nil "~a: scene ~a" (gs-as-written name) (cadr s))
            (gs-as-written name)))
      #'(lambda () (mapply1 e args name nil)))))
(defun gs-miscounted (name params least found)
  (mfuncall '$gs__error (gs-as-written name)
    (format nil "expected ~:[~;at least ~]~a argument~:p, ~a(~{~a~^, ~}); found ~a"
            (/= least (length params)) least (gs-as-written name)
            (mapcar #'(lambda (p) (if (atom p) (gs-parameter p) "...")) params) found)))
;;; Guard of a public function: its argument must be a scene.
(defun $gs__need_scene (place s)
  (unless ($gs__is_struct s '$gs__scene)
    (mfuncall '$gs__error place "the first argument must be a scene made by gsmbp_scene; found: "
              s)))
;;; a parameter as its function's comment has it
(defun gs-parameter (p)
  (let ((text (gs-as-written p)))
    (if (eql 0 (search "gs__" text)) "expression" text)))
