/** The evidence of a run in the formats that tools of requirements read. */
package dev.eventchain.pipeline.evidence.format;
