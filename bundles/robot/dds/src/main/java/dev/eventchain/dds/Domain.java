package dev.eventchain.dds;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/** A domain of this process: created for the first participant, deleted after the last one. */
final class Domain {

  /** Domains by number; guarded by the class. */
  private static final Map<Integer, Domain> DOMAINS = new HashMap<>();

  private final int id;
  private final String configuration;
  private final int handle;
  private int participants;

  private Domain(int id, String configuration, int handle) {
    this.id = id;
    this.configuration = configuration;
    this.handle = handle;
  }

  /**
   * Creates a domain, or joins the existing one.
   *
   * @throws IllegalArgumentException if the domain does not exist, or the configuration is invalid
   * @throws IllegalStateException if this process uses it with another configuration
   */
  static synchronized Domain join(Cyclone cyclone, int id, String configuration) {
    if (id < 0 || id > DdsParticipant.HIGHEST_DOMAIN) {
      throw new IllegalArgumentException(
          "There is no domain "
              + id
              + ": domains are numbered from 0 to "
              + DdsParticipant.HIGHEST_DOMAIN
              + ".");
    }
    Domain domain = DOMAINS.get(id);
    if (domain == null) {
      int handle = cyclone.createDomain(id, configuration);
      if (handle < 0) {
        throw new IllegalArgumentException(
            String.format(
                Locale.ROOT,
                "Cyclone DDS refuses domain %d with the configuration %s: %s.",
                id,
                configuration,
                Codes.text(cyclone, handle)));
      }
      domain = new Domain(id, configuration, handle);
      DOMAINS.put(id, domain);
    } else if (!domain.configuration.equals(configuration)) {
      throw new IllegalStateException(
          "Domain " + id + " is in use in this process, with a different configuration.");
    }
    domain.participants++;
    return domain;
  }

  int id() {
    return id;
  }

  static synchronized void leave(Cyclone cyclone, Domain domain) {
    domain.participants--;
    if (domain.participants == 0) {
      DOMAINS.remove(domain.id);
      cyclone.delete(domain.handle);
    }
  }
}
