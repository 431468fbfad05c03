package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.UnsavedTexts;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.nio.charset.UnsupportedCharsetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Loader of a module and all modules that it imports or extends. */
public final class ModuleLoader {
  /**
   * A module that was read.
   *
   * @param names the modules by the names used in it, as keys of {@link #load}; a missing one is an
   *     error
   */
  public record Loaded(Syntax.Module syntax, Problems problems, Map<String, String> names) {}

  private static final Pattern ENCODING =
      Pattern.compile("\\s*\\[comment\\s+encoding\\s*=\\s*([^\\s/\\]]+)");

  private static final int ENCODING_WITHIN = 1000;

  private final ModuleSources sources;
  private final List<Diagnostic> found;
  private final Map<String, Loaded> modules = new LinkedHashMap<>();

  private final Function<Problems, Syntax.Module> parser;

  private ModuleLoader(
      ModuleSources sources, List<Diagnostic> found, Function<Problems, Syntax.Module> parser) {
    this.parser = parser;
    this.sources = sources;
    this.found = found;
  }

  /** Returns all modules by the names of their texts; the main one first. */
  public static Map<String, Loaded> load(
      SourceText main, ModuleSources sources, List<Diagnostic> found) {
    return load(main, sources, found, ModuleParser::parse);
  }

  /**
   * As {@link #load(SourceText, ModuleSources, List)}, for editors, which know the modules of texts
   * that have not changed; without findings.
   *
   * @param parser returns the module of a text, such as {@link #understand}
   */
  public static Map<String, Loaded> load(
      SourceText main, ModuleSources sources, Function<SourceText, Syntax.Module> parser) {
    return load(main, sources, new ArrayList<>(), problems -> parser.apply(problems.source()));
  }

  private static Map<String, Loaded> load(
      SourceText main,
      ModuleSources sources,
      List<Diagnostic> found,
      Function<Problems, Syntax.Module> parser) {
    ModuleLoader loader = new ModuleLoader(sources, found, parser);
    loader.load(main);
    return loader.modules;
  }

  /** Returns the module of a text as far as it can be read. */
  public static Syntax.Module understand(SourceText source) {
    return ModuleParser.understand(source);
  }

  /**
   * Reads a file as UTF-8, or in the encoding that its first tag states: {@code [comment encoding =
   * NAME /]}.
   *
   * @throws DiagnosticException INPUT if it cannot be read, is not in that encoding, or there is no
   *     such encoding
   */
  public static SourceText read(Path file) {
    FileReads.note(file);
    String name = UnsavedTexts.of(file).isPresent() ? "" : encoding(file);
    if (name.isEmpty() || name.equalsIgnoreCase("UTF-8")) {
      return SourceText.read(file);
    }
    SourceLocation place = SourceLocation.of(file);
    try {
      return SourceText.of(place.file(), Files.readString(file, Charset.forName(name)));
    } catch (IllegalCharsetNameException | UnsupportedCharsetException e) {
      throw refused(SyntaxRules.CHARSET, "There is no charset '" + name + "'.", place);
    } catch (CharacterCodingException e) {
      throw refused(FileRules.ENCODING, "The file is not " + name + " text.", place);
    } catch (IOException e) {
      throw FileRules.refusal("The file", file, e);
    }
  }

  private static DiagnosticException refused(Rule rule, String message, SourceLocation place) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT, Diagnostic.of(rule, message, place));
  }

  /** Returns the encoding declared in a file; empty if there is none or the file is unreadable. */
  private static String encoding(Path file) {
    if (!Files.isRegularFile(file)) {
      return "";
    }
    try (InputStream stream = Files.newInputStream(file)) {
      String start = new String(stream.readNBytes(ENCODING_WITHIN), StandardCharsets.ISO_8859_1);
      Matcher matcher = ENCODING.matcher(start);
      return matcher.lookingAt() ? matcher.group(1) : "";
    } catch (IOException e) {
      return "";
    }
  }

  private void load(SourceText source) {
    Problems problems = new Problems(source, found);
    SourceLocation place = SourceLocation.of(source.name());
    Syntax.Module module = DiagnosticException.at(place, () -> parser.apply(problems));
    Loaded loaded = new Loaded(module, problems, new HashMap<>());
    modules.put(source.name(), loaded);
    module.extended().forEach(other -> load(other, loaded));
    module.imports().forEach(other -> load(other, loaded));
  }

  private void load(Syntax.Name name, Loaded importing) {
    SourceText from = importing.problems().source();
    Optional<SourceText> source = sources.find(importing.syntax(), from, name.text());
    if (source.isPresent()) {
      importing.names().put(name.text(), source.get().name());
      if (!modules.containsKey(source.get().name())) {
        load(source.get());
      }
      return;
    }
    // The file of a module may have another name.
    Loaded main = modules.values().iterator().next();
    Stream.of(importing, main)
        .filter(each -> each.syntax().name().equals(name.text()))
        .findFirst()
        .ifPresentOrElse(
            each -> importing.names().put(name.text(), each.problems().source().name()),
            () -> missing(name, importing.problems()));
  }

  private static void missing(Syntax.Name name, Problems problems) {
    String last = name.text().substring(name.text().lastIndexOf(':') + 1);
    String root =
        name.text().contains("::")
            ? ", or name the folder that has "
                + name.text().replace("::", "/")
                + ".mtl: --source FOLDER"
            : "";
    problems.add(
        SyntaxRules.MODULE_MISSING,
        name.start(),
        "There is no module '" + name.text() + "'.",
        "Put " + last + ".mtl next to this file" + root + ".");
  }
}
