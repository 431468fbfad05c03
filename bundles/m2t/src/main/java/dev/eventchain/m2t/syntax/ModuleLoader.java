package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.nio.charset.UnsupportedCharsetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Reads a module and all those that it imports or extends. */
public final class ModuleLoader {
  /** A module that was read. */
  public record Loaded(Syntax.Module syntax, Problems problems) {}

  private static final Pattern ENCODING =
      Pattern.compile("\\s*\\[comment\\s+encoding\\s*=\\s*([^\\s/\\]]+)");

  private static final int ENCODING_WITHIN = 1000;

  private final Function<String, Optional<SourceText>> sources;
  private final List<Diagnostic> found;
  private final Map<String, Loaded> modules = new LinkedHashMap<>();

  private ModuleLoader(Function<String, Optional<SourceText>> sources, List<Diagnostic> found) {
    this.sources = sources;
    this.found = found;
  }

  /** All modules by the name under which they are imported; the main one first. */
  public static Map<String, Loaded> load(
      SourceText main, Function<String, Optional<SourceText>> sources, List<Diagnostic> found) {
    ModuleLoader loader = new ModuleLoader(sources, found);
    loader.loadMain(main);
    return loader.modules;
  }

  /**
   * Modules in the folder of a file: {@code a::b} is {@code a/b.mtl} below it, or {@code b.mtl} in
   * it, or {@code a/b.mtl} beside the folder, where several sets of templates share modules. The
   * file itself is no module of another name.
   *
   * @param read gets the file of each module that is read
   */
  public static Function<String, Optional<SourceText>> beside(Path file, Consumer<Path> read) {
    Path folder = Optional.ofNullable(file.getParent()).orElse(Path.of(""));
    return name -> {
      String nested = name.replace("::", "/") + ".mtl";
      Path flat = folder.resolve(name.substring(name.lastIndexOf(':') + 1) + ".mtl");
      Path around = name.contains("::") ? folder.resolve("..").resolve(nested).normalize() : flat;
      return Stream.of(folder.resolve(nested), flat, around)
          .filter(found -> Files.exists(found) && !found.equals(file))
          .findFirst()
          .map(
              found -> {
                read.accept(found);
                return read(found);
              });
    };
  }

  /**
   * Reads a file as UTF-8, or as what its first tag says: {@code [comment encoding = NAME /]}.
   *
   * @throws DiagnosticException INPUT if it cannot be read, is not in that encoding, or there is no
   *     such encoding
   */
  public static SourceText read(Path file) {
    String name = encoding(file);
    if (name.isEmpty() || name.equalsIgnoreCase("UTF-8")) {
      return SourceText.read(file);
    }
    SourceLocation place = SourceLocation.of(file);
    try {
      return SourceText.of(place.file(), Files.readString(file, Charset.forName(name)));
    } catch (IllegalCharsetNameException | UnsupportedCharsetException e) {
      throw refused("m2t.charset", "There is no charset '" + name + "'.", place);
    } catch (CharacterCodingException e) {
      throw refused("file.encoding", "The file is not " + name + " text.", place);
    } catch (IOException e) {
      String message = "The file cannot be read: " + SourceText.reason(e) + ".";
      throw refused("file.unreadable", message, place);
    }
  }

  private static DiagnosticException refused(String id, String message, SourceLocation place) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT, Diagnostic.error(id, message, place));
  }

  /** The encoding that a file says it has; nothing if it does not, or cannot be read. */
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

  private void loadMain(SourceText source) {
    Problems problems = new Problems(source, found);
    Syntax.Module module = parse(problems);
    load(module.name(), module, problems);
  }

  private static Syntax.Module parse(Problems problems) {
    SourceLocation place = SourceLocation.of(problems.source().name());
    return DiagnosticException.at(place, () -> ModuleParser.parse(problems));
  }

  private void load(String name, Syntax.Module module, Problems problems) {
    modules.put(name, new Loaded(module, problems));
    module.extended().forEach(other -> load(other, problems));
    module.imports().forEach(other -> load(other, problems));
  }

  private void load(Syntax.Name name, Problems problems) {
    if (modules.containsKey(name.text())) {
      return;
    }
    Optional<SourceText> source = sources.apply(name.text());
    if (source.isPresent()) {
      Problems own = new Problems(source.get(), found);
      load(name.text(), parse(own), own);
    } else {
      problems.error(
          "m2t.module.missing",
          name.start(),
          "There is no module '" + name.text() + "'.",
          "Put "
              + name.text().substring(name.text().lastIndexOf(':') + 1)
              + ".mtl beside this file.");
    }
  }
}
