-- A gradebook as the first version of the program made it, with a row in each table.
CREATE TABLE gradebook_format (version INTEGER NOT NULL, PRIMARY KEY (version));
CREATE TABLE gradebook_attempt (
	student VARCHAR NOT NULL, number INTEGER NOT NULL, variant VARCHAR NOT NULL,
	scheme VARCHAR NOT NULL, file VARCHAR NOT NULL, digest VARCHAR(64) NOT NULL,
	graded_at DATETIME NOT NULL, course VARCHAR(64) NOT NULL, policy VARCHAR(64) NOT NULL,
	judged BOOLEAN NOT NULL, PRIMARY KEY (student, number)
);
CREATE TABLE gradebook_result (
	student VARCHAR NOT NULL, attempt INTEGER NOT NULL, place INTEGER NOT NULL,
	quantity VARCHAR NOT NULL, outcome VARCHAR NOT NULL, points DOUBLE NOT NULL,
	max_points DOUBLE NOT NULL, PRIMARY KEY (student, attempt, place),
	FOREIGN KEY(student, attempt) REFERENCES gradebook_attempt (student, number)
);
CREATE TABLE gradebook_mark (
	student VARCHAR NOT NULL, quantity VARCHAR NOT NULL, number INTEGER NOT NULL,
	supersedes INTEGER, attempt INTEGER NOT NULL, credit DOUBLE, marker VARCHAR NOT NULL,
	marked_at DATETIME NOT NULL, comment VARCHAR NOT NULL,
	PRIMARY KEY (student, quantity, number),
	FOREIGN KEY(student, attempt) REFERENCES gradebook_attempt (student, number),
	FOREIGN KEY(student, quantity, supersedes)
		REFERENCES gradebook_mark (student, quantity, number)
);
CREATE TABLE gradebook_mark_line (
	student VARCHAR NOT NULL, quantity VARCHAR NOT NULL, mark INTEGER NOT NULL,
	line VARCHAR NOT NULL, credit DOUBLE NOT NULL, PRIMARY KEY (student, quantity, mark, line),
	FOREIGN KEY(student, quantity, mark) REFERENCES gradebook_mark (student, quantity, number)
);
INSERT INTO gradebook_format VALUES (1);
INSERT INTO gradebook_attempt VALUES
	('s01', 1, '001', 'rack', 's01.xlsx', 'aa', '2026-12-02 09:00:00.000000', 'cc', 'dd', 1);
INSERT INTO gradebook_result VALUES ('s01', 1, 1, 'drawing', 'manual', 0.0, 10.0);
INSERT INTO gradebook_mark VALUES
	('s01', 'drawing', 1, NULL, 1, 0.5, 'Петров', '2026-12-03 09:00:00.000000', 'Один вид.');
INSERT INTO gradebook_mark_line VALUES ('s01', 'drawing', 1, 'sizes', 0.5);
