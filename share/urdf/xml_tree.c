/* xml_tree FILE [lenient]: the elements of an XML file as one list for Lisp's reader, on stdout:

     ("tag" line (("attribute" . "value") ...) (child ...))

   or (:error line "what is wrong"). With the word lenient another version of XML is read as 1.0,
   and a document type without declarations is left out: a list (:note line "what") before the
   other one tells each. Texts between elements are left out. Characters beyond
   printable ASCII stand as \u00e9, so that the list holds nothing but plain strings and numbers.

   Nothing but FILE is read: no network, no external entity, no document type. A file over 10 MB,
   one with a document type (DOCTYPE), of more than 12000 elements, or with an element of more than
   1000 attributes is refused before it is parsed, one of more than 500 links or joints, or with
   an attribute of more than 10000 characters, before it is printed. */

#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <libxml/parser.h>
#include <libxml/tree.h>

#define TYPE "a document type (DOCTYPE) is not taken: no entity is expanded, nothing else is read"
#define LARGEST 10000000L
#define LONGEST 10000                  /* characters of an attribute */
#define MOST 12000L                    /* elements: three times those of the largest robots */
#define MOST_ATTRIBUTES 1000L          /* of an element: a parser's time grows with their square */
#define MOST_PARTS 500L                /* links, joints: more make no equations one waits for */

static void put_text(const xmlChar *s)
{
  int length, c;
  putchar('"');
  while (*s) {
    length = 4;
    c = xmlGetUTF8Char(s, &length);
    if (c < 0) { c = '?'; length = 1; }
    if (c == '"' || c == '\\') printf("\\%c", c);
    else if (c >= ' ' && c < 127) putchar(c);
    else printf("\\\\u%04x", c);
    s += length;
  }
  putchar('"');
}

static void refuse(long line, const char *what)
{
  printf("(:error %ld ", line);
  put_text((const xmlChar *) what);
  printf(")\n");
  exit(0);
}

/* the whole file; *n bytes */
static char *whole(const char *name, long *n)
{
  FILE *f = fopen(name, "rb");
  char *text;
  if (!f) refuse(0, "the file cannot be read");
  text = malloc(LARGEST + 2);
  if (!text) refuse(0, "no memory");
  *n = (long) fread(text, 1, LARGEST + 1, f);
  if (ferror(f)) refuse(0, "the file cannot be read");
  fclose(f);
  if (*n > LARGEST) refuse(0, "expected at most 10 MB, found more");
  if (*n == 0) refuse(0, "the file is empty");
  text[*n] = 0;
  return text;
}

/* whether the word stands in the text, in whatever encoding that keeps ASCII or puts zeros
   between; *line: where */
static int holds(const char *text, long n, const char *word, long *line)
{
  long i, k = 0;
  *line = 1;
  for (i = 0; i < n; i++) {
    if (text[i] == '\n') ++*line;
    if (text[i] == 0) continue;
    k = text[i] == word[k] ? k + 1 : text[i] == word[0];
    if (!word[k]) return 1;
  }
  return 0;
}

static int lenient;

static void note(long line, const char *what)
{
  printf("(:note %ld ", line);
  put_text((const xmlChar *) what);
  printf(")\n");
}

/* the version of XML that the text declares, *length characters; NULL where it declares none */
static char *version_of(char *text, size_t *length)
{
  char *end, *v;
  if (!strncmp(text, "\xef\xbb\xbf", 3)) text += 3;
  end = strncmp(text, "<?xml", 5) ? NULL : strstr(text, "?>");
  v = end ? strstr(text, "version") : NULL;
  if (!v || v > end) return NULL;
  v += strcspn(v, "\"'?");
  *length = strcspn(v + 1, "\"'?");
  return v[*length + 1] == *v ? v + 1 : NULL;
}

/* a version of XML that is none; lenient: 1.0 */
static void take_version(char *text)
{
  size_t length;
  char what[200], *v = version_of(text, &length);
  if (!v || !strncmp(v, "1.", 2)) return;
  snprintf(what, sizeof what, "XML version %.*s: expected 1.0%s", (int) (length < 20 ? length : 20),
           v, length < 3 ? "; remedy: correct it" : lenient ? ": it is read as 1.0"
           : "; remedy: correct it, or lenient = true: it is read as 1.0");
  if (!lenient || length < 3) refuse(1, what);
  note(1, what);
  v[length] = ' ';
  memset(v, ' ', length);
  memcpy(v, "1.0", 3);
  v[3] = v[-1];
}

/* lenient: blanks instead of a document type without declarations; one with them is refused */
static void take_type(char *text, long n)
{
  long line;
  char *from, *to, quote = 0;
  while (lenient && (from = memmem(text, n, "<!DOCTYPE", 9))) {
    for (to = from; to < text + n && (quote || (*to != '>' && *to != '[')); to++)
      if (quote) { if (*to == quote) quote = 0; }
      else if (*to == '"' || *to == '\'') quote = *to;
    if (to == text + n || *to == '[') break;
    holds(text, n, "<!DOCTYPE", &line);
    note(line, "a document type (DOCTYPE): it is left out, nothing else is read");
    for (; from <= to; from++)
      if (*from != '\n') *from = ' ';
  }
  if (holds(text, n, "<!DOCTYPE", &line))
    refuse(line, lenient ? TYPE ", with declarations not with lenient = true either; remedy: "
           "take it out" : TYPE "; remedy: take it out, or lenient = true, where it has no "
           "declarations");
}

/* where the text behind i has its first end from there on: a place behind it */
static long behind(const char *text, long n, long i, const char *end, long *line)
{
  long k = 0;
  for (; i < n && end[k]; i++) {
    if (text[i] == '\n') ++*line;
    if (text[i]) k = text[i] == end[k] ? k + 1 : text[i] == end[0] ? k ? k : 1 : 0;
  }
  return i;
}

/* refuses a text of too many elements, or with one of too many attributes, in whatever encoding
   that keeps ASCII or puts zeros between */
static void count_tags(const char *text, long n)
{
  long i = 0, line = 1, many = 0;
  while (i < n) {
    char c[4] = "";
    long k = 0, j, attributes = 0;
    char quote = 0;
    if (text[i] == '\n') ++line;
    if (text[i++] != '<') continue;
    for (j = i; j < n && k < 3; j++)
      if (text[j]) c[k++] = text[j];
    if (!strcmp(c, "!--")) { i = behind(text, n, j, "-->", &line); continue; }
    if (!strcmp(c, "![C")) { i = behind(text, n, j, "]]>", &line); continue; }
    if (c[0] == '?') { i = behind(text, n, i, "?>", &line); continue; }
    if (c[0] == '/') continue;
    if (++many > MOST) refuse(0, "expected at most 12000 elements, found more");
    for (j = line; i < n && (quote || text[i] != '>'); i++) {
      if (text[i] == '\n') ++j;
      if (quote) { if (text[i] == quote) quote = 0; }
      else if (text[i] == '"' || text[i] == '\'') quote = text[i];
      else if (text[i] == '=' && ++attributes > MOST_ATTRIBUTES)
        refuse(line, "expected at most 1000 attributes of an element, found more");
    }
    line = j;
  }
}

static void forbidden(void *context, const xmlChar *name, const xmlChar *id, const xmlChar *system)
{
  (void) context; (void) name; (void) id; (void) system;
  refuse(0, TYPE);
}

static xmlParserInputPtr nothing_else(const char *url, const char *id, xmlParserCtxtPtr context)
{
  (void) url; (void) id; (void) context;
  return NULL;
}

/* the first thing that is wrong, on one line */
static char first_error[500];
static int first_line;

static void noted(void *context, xmlErrorPtr e)
{
  (void) context;
  if (first_error[0] || e->level < XML_ERR_ERROR || e->domain == XML_FROM_NAMESPACE) return;
  strncpy(first_error, e->message ? e->message : "no XML", sizeof first_error - 1);
  first_error[strcspn(first_error, "\n")] = 0;
  first_line = e->line;
}

/* prefix:name, as the file has it */
static void put_name(const xmlNs *space, const xmlChar *name)
{
  if (space && space->prefix) {
    xmlChar *whole_name = xmlBuildQName(name, space->prefix, NULL, 0);
    put_text(whole_name);
    xmlFree(whole_name);
  } else
    put_text(name);
}

static void put_element(const xmlNode *node)
{
  const xmlAttr *a;
  const xmlNode *child;
  printf("(");
  put_name(node->ns, node->name);
  printf(" %ld (", xmlGetLineNo((xmlNode *) node));
  for (a = node->properties; a; a = a->next) {
    xmlChar *value = xmlNodeListGetString(node->doc, a->children, 1);
    printf("(");
    put_name(a->ns, a->name);
    printf(" . ");
    put_text(value ? value : (const xmlChar *) "");
    printf(")");
    xmlFree(value);
  }
  printf(") (");
  for (child = node->children; child; child = child->next)
    if (child->type == XML_ELEMENT_NODE) put_element(child);
  printf("))\n");
}

/* the elements of a node and below, whose attributes are not too long */
static long elements(const xmlNode *node)
{
  const xmlNode *child;
  const xmlAttr *a;
  long n = 1;
  for (a = node->properties; a; a = a->next)
    if (a->children && a->children->content && xmlStrlen(a->children->content) > LONGEST)
      refuse(xmlGetLineNo((xmlNode *) node),
             "expected at most 10000 characters in an attribute, found more");
  for (child = node->children; child; child = child->next)
    if (child->type == XML_ELEMENT_NODE) n += elements(child);
  return n;
}

/* refuses too many children of that tag */
static void count_parts(const xmlNode *root, const char *tag)
{
  const xmlNode *child;
  char what[100];
  long n = 0;
  for (child = root->children; child; child = child->next)
    n += child->type == XML_ELEMENT_NODE && !strcmp((const char *) child->name, tag);
  snprintf(what, sizeof what, "expected at most %ld elements %s, found %ld", MOST_PARTS, tag, n);
  if (n > MOST_PARTS) refuse(xmlGetLineNo((xmlNode *) root), what);
}

int main(int argc, char **argv)
{
  long n;
  char *text;
  xmlParserCtxtPtr context;
  xmlDocPtr doc;
  if (argc < 2) return 1;
  lenient = argc > 2 && !strcmp(argv[2], "lenient");
  text = whole(argv[1], &n);
  take_type(text, n);
  take_version(text);
  count_tags(text, n);
  xmlSetExternalEntityLoader(nothing_else);
  xmlSetStructuredErrorFunc(NULL, noted);
  context = xmlNewParserCtxt();
  if (!context) refuse(0, "no memory");
  context->sax->internalSubset = forbidden;
  doc = xmlCtxtReadMemory(context, text, (int) n, NULL, NULL,
                          XML_PARSE_NONET | XML_PARSE_NOCDATA | XML_PARSE_BIG_LINES);
  if (!doc || !context->wellFormed)
    refuse(first_line, first_error[0] ? first_error : "no XML");
  if (doc->intSubset) forbidden(NULL, NULL, NULL, NULL);
  if (elements(xmlDocGetRootElement(doc)) > MOST)
    refuse(0, "expected at most 12000 elements, found more");
  count_parts(xmlDocGetRootElement(doc), "link");
  count_parts(xmlDocGetRootElement(doc), "joint");
  put_element(xmlDocGetRootElement(doc));
  return 0;
}
