package dev.eventchain.dds;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Wrong use throws a clear exception, and the process continues. */
class WrongUseTest {

  private static final QosSettings QOS = QosSettings.named("default").orElseThrow();
  private static final MessageType FLOAT = RandomMessages.type("std_msgs/msg/Float32");
  private static final MessageType SCAN = RandomMessages.type("sensor_msgs/msg/LaserScan");
  private static final byte[] NUMBER = CdrCodec.encode(MessageValue.of(FLOAT));

  @TempDir Path folder;

  private static void refused(String message, Runnable use) {
    RuntimeException problem = assertThrows(RuntimeException.class, use::run);
    assertTrue(
        problem instanceof IllegalStateException || problem instanceof IllegalArgumentException,
        problem::toString);
    assertEquals(message, problem.getMessage());
  }

  private static String unavailable(Optional<Path> path, Map<String, String> settings) {
    DiagnosticException problem =
        assertThrows(DiagnosticException.class, () -> DdsLibrary.load(path, settings));
    assertEquals(DiagnosticException.Reason.UNAVAILABLE, problem.reason());
    Diagnostic found = problem.diagnostics().get(0);
    assertEquals("dds.unavailable", found.id());
    assertTrue(found.hint().contains("EVENTCHAIN_LIBDDSC"), found::hint);
    return found.message();
  }

  @Test
  void withoutLibraryTheMessageSaysWhatToDo() {
    assertEquals("No Cyclone DDS library was found.", unavailable(Optional.empty(), Map.of()));
  }

  @Test
  void aLibraryThatIsNotThereIsNamed() {
    Path nowhere = folder.resolve("libddsc.so");
    assertEquals(
        "The Cyclone DDS library, " + nowhere + ", does not exist.",
        unavailable(Optional.of(nowhere), Map.of()));
    assertEquals(
        "The Cyclone DDS library, " + nowhere + ", does not exist.",
        unavailable(Optional.empty(), Map.of("EVENTCHAIN_LIBDDSC", nowhere.toString())));
  }

  @Test
  void anotherLibraryThanTheLoadedOneIsRefused() throws IOException {
    DdsLibrary library = Wire.library();
    Path other = Files.writeString(folder.resolve("libddsc.so"), "no library");
    assertEquals(
        "This process already uses " + library.path() + ", not " + other.toRealPath() + ".",
        unavailable(Optional.of(other), Map.of()));
    assertEquals(library, DdsLibrary.load(Optional.of(library.path())));
    assertEquals(
        library,
        DdsLibrary.load(Optional.empty(), Map.of("EVENTCHAIN_LIBDDSC", library.path().toString())));
  }

  @Test
  void closedWritersReadersAndParticipantsRefuse() {
    DdsParticipant participant = Wire.alone();
    DdsWriter writer = participant.writer("/a", FLOAT, QOS);
    DdsReader reader = participant.reader("/a", FLOAT, QOS);
    DdsWriter other = participant.writer("/b", FLOAT, QOS);
    writer.close();
    reader.close();
    writer.close();
    reader.close();
    refused("The writer of /a is closed.", () -> writer.write(NUMBER));
    refused("The writer of /a is closed.", () -> writer.write(NUMBER, 1));
    refused("The writer of /a is closed.", writer::matched);
    refused("The writer of /a is closed.", writer::events);
    refused("The writer of /a is closed.", writer::assertLiveliness);
    refused("The writer of /a is closed.", () -> writer.waitForMatches(1, Wire.PATIENCE));
    refused("The reader of /a is closed.", reader::take);
    refused("The reader of /a is closed.", () -> reader.take(Wire.PATIENCE));
    refused("The reader of /a is closed.", reader::matched);
    refused("The reader of /a is closed.", reader::events);
    refused("The reader of /a is closed.", () -> reader.waitForMatches(1, Wire.PATIENCE));
    participant.close();
    participant.close();
    refused("The writer of /b is closed.", () -> other.write(NUMBER));
    refused("This participant is closed.", () -> participant.writer("/a", FLOAT, QOS));
    refused("This participant is closed.", () -> participant.reader("/a", FLOAT, QOS));
    refused("This participant is closed.", () -> participant.announce("a"));
  }

  @Test
  void aReaderWithAListenerIsNotTakenFrom() {
    try (DdsParticipant participant = Wire.alone()) {
      DdsReader reader = participant.reader("/a", FLOAT, QOS, sample -> {});
      refused("The samples of /a are delivered to its listener.", reader::take);
    }
  }

  @Test
  void bytesThatAreNotOfTheTypeAreRefused() {
    try (DdsParticipant participant = Wire.alone()) {
      DdsWriter numbers = participant.writer("/numbers", FLOAT, QOS);
      refused(
          "The bytes end before the message std_msgs/msg/Float32 does.",
          () -> numbers.write(new byte[0]));
      refused(
          "The bytes end before the message std_msgs/msg/Float32 does.",
          () -> numbers.write(new byte[] {0, 1, 0, 0, 1, 2, 3}));
      refused(
          "4 bytes follow the message std_msgs/msg/Float32.",
          () -> numbers.write(Arrays.copyOf(NUMBER, NUMBER.length + 4)));
      refused(
          "Representation 7 is not plain CDR (0 or 1).",
          () -> numbers.write(new byte[] {0, 7, 0, 0, 0, 0, 0, 0}));
      refused("A source timestamp must not be negative: -1", () -> numbers.write(NUMBER, -1));
      DdsWriter texts =
          participant.writer("/texts", RandomMessages.type("std_msgs/msg/String"), QOS);
      byte[] unterminated = HexFormat.of().parseHex("00010000" + "02000000" + "6162");
      refused(
          "The bytes are not a message of the type std_msgs/msg/String.",
          () -> texts.write(unterminated));
      DdsWriter flags = participant.writer("/flags", RandomMessages.type("std_msgs/msg/Bool"), QOS);
      refused("A bool is 0 or 1, not 2.", () -> flags.write(new byte[] {0, 1, 0, 0, 2}));
    }
  }

  @Test
  void anyBytesAreAMessageOrRefused() {
    byte[] good = CdrCodec.encode(new RandomMessages(5).next(SCAN));
    Random random = new Random(6);
    int written = 0;
    try (DdsParticipant participant = Wire.alone()) {
      DdsWriter writer = participant.writer("/scan", SCAN, QOS);
      DdsReader reader = participant.reader("/scan", SCAN, QOS);
      for (int i = 0; i < 20_000; i++) {
        byte[] bytes = Arrays.copyOf(good, random.nextInt(good.length + 8));
        for (int flips = random.nextInt(4); flips > 0 && bytes.length > 0; flips--) {
          bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
        }
        try {
          assertTrue(writer.write(bytes, i));
          written++;
          // Bytes that were accepted as a message can be decoded.
          for (DdsSample sample : reader.take()) {
            CdrCodec.requireMessage(SCAN, sample.bytes());
          }
        } catch (IllegalArgumentException e) {
          assertTrue(!String.valueOf(e.getMessage()).isBlank());
        }
      }
    }
    assertTrue(written > 0, "none was written");
    assertTrue(written < 20_000, "none was refused");
  }

  @Test
  void domainsTopicsTypesAndTagsThatDoNotExistAreRefused() {
    DdsLibrary library = Wire.library();
    String configuration = DdsParticipant.loopbackConfiguration("a");
    for (int domain : new int[] {-1, 233, Integer.MAX_VALUE}) {
      refused(
          "There is no domain " + domain + ": domains are numbered from 0 to 232.",
          () -> DdsParticipant.on(library, domain, configuration).close());
    }
    for (String tag : List.of("", "a b", "<a/>", "a".repeat(65))) {
      refused(
          "'" + tag + "' is not a tag: up to 64 letters, digits, '_', '.' and '-'.",
          () -> DdsParticipant.loopbackConfiguration(tag));
    }
    try (DdsParticipant participant = Wire.alone()) {
      for (String topic : List.of("", "scan", "~/scan", "/1", "/a//b", "/a b")) {
        refused(
            "'" + topic + "' is not the full name of a topic, such as /scan.",
            () -> participant.writer(topic, FLOAT, QOS));
      }
      participant.writer("/scan", SCAN, QOS);
      refused(
          "Topic rt/scan has the type sensor_msgs/msg/LaserScan, not std_msgs/msg/Float32.",
          () -> participant.reader("/scan", FLOAT, QOS));
    }
  }

  @Test
  void aDomainHasOneConfigurationInAProcess() {
    DdsLibrary library = Wire.library();
    int domain = Wire.newDomain();
    String tag = Wire.newTag();
    try (DdsParticipant first = DdsParticipant.loopback(library, domain, tag);
        DdsParticipant second = DdsParticipant.loopback(library, domain, tag)) {
      refused(
          "Domain " + domain + " is in use in this process, with a different configuration.",
          () -> DdsParticipant.loopback(library, domain, Wire.newTag()));
      first.writer("/a", FLOAT, QOS);
      assertTrue(second.reader("/a", FLOAT, QOS).waitForMatches(1, Wire.PATIENCE));
    }
    DdsParticipant.loopback(library, domain, Wire.newTag()).close();
  }

  @Test
  void aConfigurationThatCycloneRefusesIsNamed() {
    DdsLibrary library = Wire.library();
    int domain = Wire.newDomain();
    RuntimeException problem =
        assertThrows(
            IllegalArgumentException.class,
            () -> DdsParticipant.on(library, domain, "<CycloneDDS><Nothing/></CycloneDDS>"));
    assertTrue(
        problem.getMessage().startsWith("Cyclone DDS refuses domain " + domain + " with the"),
        problem::getMessage);
    DdsParticipant.loopback(library, domain, Wire.newTag()).close();
  }

  @Test
  void waitingEndsWithTheTime() {
    try (DdsParticipant participant = Wire.alone()) {
      DdsReader reader = participant.reader("/a", FLOAT, QOS);
      assertEquals(List.of(), reader.take(Duration.ofMillis(20)));
      assertEquals(false, reader.waitForMatches(1, Duration.ofMillis(20)));
    }
  }
}
