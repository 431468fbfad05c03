/**
 * A user's folder: where its files are, its settings, requirements, software base and suppressions.
 * It reads them and judges no chain.
 */
package dev.eventchain.project;
