package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/**
 * Reads the ReqIF files in a {@code .reqifz}. Nothing is unpacked to the disk; entries with names
 * outside the archive, too many of them, and those that are too long are refused.
 */
final class ReqIfArchive {

  private static final int MOST_ENTRIES = 10_000;

  private ReqIfArchive() {}

  static void read(Path file, Reading reading) {
    FileReads.note(file);
    if (!Files.isRegularFile(file)) {
      SourceText.read(file); // says what is wrong
    }
    List<SourceText> texts = new ArrayList<>();
    try (ZipFile zip = new ZipFile(file.toFile())) {
      if (zip.size() > MOST_ENTRIES) {
        throw refused(file, "it has more than " + MOST_ENTRIES + " entries");
      }
      int left = Reading.LONGEST;
      for (ZipEntry entry : entries(zip, file)) {
        byte[] bytes = bytes(zip, entry, left, file);
        left -= bytes.length;
        texts.add(text(file, entry, bytes));
      }
    } catch (IOException | IllegalArgumentException e) {
      throw refused(file, "it is no zip file that can be read");
    }
    if (texts.isEmpty()) {
      throw refused(file, "it has no .reqif file");
    }
    texts.forEach(text -> ReqIfReader.read(text, reading));
  }

  /** Returns the entries of ReqIF files in the order of their names. */
  private static List<? extends ZipEntry> entries(ZipFile zip, Path file) {
    List<? extends ZipEntry> all = zip.stream().toList();
    for (ZipEntry entry : all) {
      String name = entry.getName();
      if (name.startsWith("/")
          || name.contains("\\")
          || name.matches("[A-Za-z]:.*")
          || List.of(name.split("/", -1)).contains("..")) {
        throw refused(file, "the name of the entry '" + name + "' leads out of it");
      }
    }
    return all.stream()
        .filter(entry -> !entry.isDirectory())
        .filter(entry -> entry.getName().toLowerCase(Locale.ROOT).endsWith(".reqif"))
        .sorted(Comparator.comparing(ZipEntry::getName))
        .toList();
  }

  private static byte[] bytes(ZipFile zip, ZipEntry entry, int most, Path file) throws IOException {
    try (InputStream input = zip.getInputStream(entry)) {
      byte[] bytes = input.readNBytes(most + 1);
      if (bytes.length > most) {
        throw refused(file, "its ReqIF files have more than " + Reading.LONGEST + " bytes");
      }
      return bytes;
    }
  }

  private static SourceText text(Path file, ZipEntry entry, byte[] bytes) {
    try {
      String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
      return SourceText.of(SourceLocation.of(file).file() + "!/" + entry.getName(), text);
    } catch (CharacterCodingException e) {
      throw refused(file, "its entry '" + entry.getName() + "' is not UTF-8 text");
    }
  }

  private static DiagnosticException refused(Path file, String why) {
    return Reading.refused(
        "The archive is not read: " + why + ".",
        SourceLocation.of(file),
        "A .reqifz is a zip file of .reqif files in UTF-8 and of what they show.");
  }
}
