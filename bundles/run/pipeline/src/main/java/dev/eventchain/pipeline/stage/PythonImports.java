package dev.eventchain.pipeline.stage;

import java.util.Arrays;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Imports in the text of a Python file, which is not run and may have errors. */
public final class PythonImports {

  /**
   * {@code sys.stdlib_module_names} of Python 3.10 to 3.14, without names that start with "_" but
   * for {@code __future__}, which programs import, too.
   */
  private static final Set<String> STANDARD_LIBRARY =
      Set.copyOf(
          Arrays.asList(
              """
              abc aifc annotationlib antigravity argparse array ast asynchat asyncio asyncore atexit
              audioop base64 bdb binascii binhex bisect builtins bz2 cProfile calendar cgi cgitb
              chunk cmath cmd code codecs codeop collections colorsys compileall compression
              concurrent configparser contextlib contextvars copy copyreg crypt csv ctypes curses
              dataclasses datetime dbm decimal difflib dis distutils doctest email encodings
              ensurepip enum errno faulthandler fcntl filecmp fileinput fnmatch fractions ftplib
              functools gc genericpath getopt getpass gettext glob graphlib grp gzip hashlib heapq
              hmac html http idlelib imaplib imghdr imp importlib inspect io ipaddress itertools
              json keyword lib2to3 linecache locale logging lzma mailbox mailcap marshal math
              mimetypes mmap modulefinder msilib msvcrt multiprocessing netrc nis nntplib nt ntpath
              nturl2path numbers opcode operator optparse os ossaudiodev pathlib pdb pickle
              pickletools pipes pkgutil platform plistlib poplib posix posixpath pprint profile
              pstats pty pwd py_compile pyclbr pydoc pydoc_data pyexpat queue quopri random re
              readline reprlib resource rlcompleter runpy sched secrets select selectors shelve
              shlex shutil signal site smtpd smtplib sndhdr socket socketserver spwd sqlite3
              sre_compile sre_constants sre_parse ssl stat statistics string stringprep struct
              subprocess sunau symtable sys sysconfig syslog tabnanny tarfile telnetlib tempfile
              termios textwrap this threading time timeit tkinter token tokenize tomllib trace
              traceback tracemalloc tty turtle turtledemo types typing unicodedata unittest urllib
              uu uuid venv warnings wave weakref webbrowser winreg winsound wsgiref xdrlib xml
              xmlrpc zipapp zipfile zipimport zlib zoneinfo __future__
              """
                  .strip()
                  .split("\\s+")));

  private static final Pattern IMPORT =
      Pattern.compile(
          "\\bfrom[ \\t]+(?<from>[\\w.]*)[ \\t]*\\bimport\\b[^\\n;]*"
              + "|\\bimport[ \\t]+(?<names>[^\\n;]+)",
          Pattern.UNICODE_CHARACTER_CLASS);

  private static final Pattern IMPORT_OF_NAMES =
      Pattern.compile(
          "\\bfrom[ \\t]+(?<from>[\\w.]+)[ \\t]*\\bimport\\b[ \\t]*(?<parts>\\([^)]*\\)?|[^\\n;]*)"
              + "|\\bimport[ \\t]+(?<names>[^\\n;]+)",
          Pattern.UNICODE_CHARACTER_CLASS);

  private PythonImports() {}

  /** Returns whether a top-level module is part of Python itself. */
  public static boolean isStandard(String module) {
    return STANDARD_LIBRARY.contains(module);
  }

  /** Returns the top-level names of imported modules, with their first locations. */
  public static SortedMap<String, Integer> modules(String text) {
    SortedMap<String, Integer> modules = new TreeMap<>();
    Matcher found = IMPORT.matcher(code(text));
    while (found.find()) {
      boolean names = found.group("names") != null;
      for (String name : (names ? found.group("names") : found.group("from")).split(",", -1)) {
        String module = name.strip().replaceFirst("[.\\s].*", "");
        if (!module.isEmpty()) { // otherwise a module of the package itself
          modules.putIfAbsent(module, found.start());
        }
      }
    }
    return modules;
  }

  /**
   * Returns the full names of all that may be an imported module, with the dots of relative
   * imports: of {@code from a.b import c}, both {@code a.b} and {@code a.b.c}.
   */
  static SortedSet<String> candidates(String text) {
    SortedSet<String> names = new TreeSet<>();
    Matcher found = IMPORT_OF_NAMES.matcher(code(text));
    while (found.find()) {
      String from = found.group("from");
      for (String part : found.group(from == null ? "names" : "parts").split(",", -1)) {
        String name = part.replaceAll("[()]", " ").strip().replaceFirst("\\s.*", "");
        if (from == null) {
          names.add(name);
        } else {
          names.add(from);
          names.add(from.endsWith(".") ? from + name : from + "." + name);
        }
      }
    }
    names.removeIf(name -> !name.matches("\\.*[\\w.]*\\w"));
    return names;
  }

  /** Returns the text with comments, strings and continued line ends blanked. */
  private static String code(String text) {
    StringBuilder code = new StringBuilder(text);
    int start = 0;
    while (start < text.length()) {
      char first = text.charAt(start);
      int end = start;
      if (first == '#') {
        end = lineEnd(text, start);
      } else if (first == '"' || first == '\'') {
        end = stringEnd(text, start);
      } else if (first == '\\') {
        end = Math.min(text.length(), start + (text.startsWith("\r\n", start + 1) ? 3 : 2));
      }
      for (int i = start; i < end; i++) {
        code.setCharAt(i, ' ');
      }
      start = Math.max(end, start + 1);
    }
    return code.toString();
  }

  private static int lineEnd(String text, int start) {
    int end = text.indexOf('\n', start);
    return end < 0 ? text.length() : end;
  }

  private static int stringEnd(String text, int start) {
    String quote = text.substring(start, start + 1);
    String delimiter = text.startsWith(quote.repeat(3), start) ? quote.repeat(3) : quote;
    int end = start + delimiter.length();
    while (end < text.length()) {
      if (text.startsWith(delimiter, end)) {
        return end + delimiter.length();
      }
      if (delimiter.length() == 1 && text.charAt(end) == '\n') {
        return end;
      }
      end += text.charAt(end) == '\\' ? 2 : 1;
    }
    return text.length();
  }
}
