# Turns the raw lines of the benchmark into tables in Markdown. -v clock=cpu: programs of one thread are compared by CPU
# time.

# The value of a field of the line; "" if there is none.
function field(name,    at, rest, end) {
    at = index($0, "\"" name "\":")
    if (!at)
        return ""
    rest = substr($0, at + length(name) + 3)
    if (substr(rest, 1, 1) == "\"") {
        rest = substr(rest, 2)
        return substr(rest, 1, index(rest, "\"") - 1)
    }
    end = match(rest, /[,}]/)
    return substr(rest, 1, end - 1)
}

# The median of the numbers in a space-separated list.
function median(list,    count, numbers, i, k, x) {
    count = split(list, numbers, " ")
    for (i = 2; i <= count; i++) {
        x = numbers[i] + 0
        for (k = i - 1; k >= 1 && numbers[k] + 0 > x; k--)
            numbers[k + 1] = numbers[k]
        numbers[k + 1] = x
    }
    if (count % 2)
        return numbers[(count + 1) / 2] + 0
    return (numbers[count / 2] + numbers[count / 2 + 1]) / 2
}

# The least of the numbers in a space-separated list.
function least(list,    count, numbers, i, x) {
    count = split(list, numbers, " ")
    x = numbers[1]
    for (i = 2; i <= count; i++)
        x = numbers[i] < x ? numbers[i] : x
    return x
}

# A number with two or three significant digits.
function short(x) {
    return sprintf(x >= 99.95 ? "%.0f" : x >= 9.995 ? "%.1f" : x >= 0.0995 ? "%.2f" : "%.2g", x)
}

function remember_order(section, row, program) {
    if (!((section) in section_rows))
        section_list[++sections] = section
    if (!((section, row) in row_seen)) {
        row_seen[section, row] = 1
        row_list[section, ++section_rows[section]] = row
    }
    if (!((section, program) in program_seen)) {
        program_seen[section, program] = 1
        program_list[section, ++section_programs[section]] = program
    }
}

{
    section = field("section")
    row = field("kind") "|" field("points") "|" field("dim")
    program = field("name")
    reference = field("reference")
    key = section SUBSEP row SUBSEP program
    remember_order(section, row, program)
    if (section == "families" && field("kind") == "uniform" && field("points") > largest_uniform)
        largest_uniform = field("points") + 0
    row_reference[section, row] = reference
    if (field("failed") != "") {
        failure[key] = field("failed")
        next
    }
    wall = field("seconds") / field("calls")
    cpu = field("cpu_seconds") / field("calls")
    if (field("jobs") == 1 && program !~ /\/x/) {
        single++
        if (wall > 1.05 * cpu + 0.001)
            delayed++
    }
    compared = clock == "cpu" && field("jobs") == 1 ? cpu : wall
    if (program == reference) {
        last_wall[section, row] = wall
        last_cpu[section, row] = cpu
    } else {
        base = clock == "cpu" && field("jobs") == 1 ? last_cpu[section, row] : last_wall[section, row]
        ratios[key] = ratios[key] " " compared / base
    }
    times[key] = times[key] " " compared
    walls[key] = walls[key] " " wall
    cells[key] = field("cells")
    if (field("hash") != "")
        hash[key] = field("hash")
    if (field("calls") == 1 && program !~ /\/x/)
        memory[key] = memory[key] " " (field("peak_rss_bytes") - field("rss_before_bytes")) / field("n")
}

# --- a table is filled cell by cell and then printed with aligned columns ---------------------------------------------

function clear_table(    i) {
    for (i in cell)
        delete cell[i]
    for (i in width)
        delete width[i]
    height = 0
}

function put(line, column, text) {
    cell[line, column] = text
    if (length(text) > width[column])
        width[column] = length(text)
    if (line > height)
        height = line
}

function print_table(columns,    line, column, text) {
    for (line = 0; line <= height; line++) {
        text = "|"
        for (column = 1; column <= columns; column++)
            text = text sprintf(column == 1 ? " %-" width[column] "s |" : " %" width[column] "s |", cell[line, column])
        print text
        if (line == 0) {
            text = "|"
            for (column = 1; column <= columns; column++)
                text = text substr("--------------------------------", 1, width[column] + 1) (column == 1 ? "-|" : ":|")
            print text
        }
    }
}

# The text for a program in a row of a table. what: ratio, relative, time, memory
function value(what, section, row, program,    key, reference_key) {
    key = section SUBSEP row SUBSEP program
    reference_key = section SUBSEP row SUBSEP row_reference[section, row]
    if (what == "ratio") {
        if (key in failure)
            return failure[key]
        if (key == reference_key)
            return 1
        if (!(key in ratios))
            return "-"
        return short(median(ratios[key])) \
            ((key in hash) && (reference_key in hash) && hash[key] != hash[reference_key] ? " !" : "")
    }
    if (what == "relative")
        return (key in times) && cells[key] > 0 && uniform_time(program) ? \
            short(1e9 * median(times[key]) / cells[key] / uniform_time(program)) : "-"
    if (what == "time")
        return (key in times) && cells[key] > 0 ? short(1e9 * median(times[key]) / cells[key]) : "-"
    return key in memory ? short(median(memory[key])) : "-"
}

# Nanoseconds per cell on the largest uniform set of the families; 0: the program did not run there.
function uniform_time(program,    key) {
    key = "families" SUBSEP "uniform|" largest_uniform "|3" SUBSEP program
    return (key in times) && cells[key] > 0 ? 1e9 * median(times[key]) / cells[key] : 0
}

function print_section(section, what,    r, p, parts, row, columns, reference_key) {
    clear_table()
    put(0, 1, "points")
    put(0, 2, "n")
    put(0, 3, "d")
    put(0, 4, "cells")
    put(0, 5, "reference s")
    columns = 5
    for (r = 1; r <= section_rows[section]; r++) {
        row = row_list[section, r]
        reference_key = section SUBSEP row SUBSEP row_reference[section, row]
        split(row, parts, "|")
        put(r, 1, parts[1])
        put(r, 2, parts[2])
        put(r, 3, parts[3])
        put(r, 4, cells[reference_key])
        put(r, 5, reference_key in times ? short(median(times[reference_key])) : "-")
    }
    for (p = 1; p <= section_programs[section]; p++) {
        columns++
        put(0, columns, program_list[section, p])
        for (r = 1; r <= section_rows[section]; r++)
            put(r, columns, value(what, section, row_list[section, r], program_list[section, p]))
    }
    print_table(columns)
}

# The median over the rounds of the ratio of two times. alone, other: lists of times, one a round
function paired(alone, other,    a, b, rounds, i, quotients) {
    rounds = split(alone, a, " ")
    if (split(other, b, " ") < rounds)
        rounds = split(other, b, " ")
    for (i = 1; i <= rounds; i++)
        quotients = quotients " " a[i] / b[i]
    return median(quotients)
}

# The chart of speed-ups: the wall time of one job over the wall time of several jobs of the same code. One job: ParaDT
# undivided, or a peer with one thread. Other guests of a host slow a processor down for tenths of a second, and then
# one of two threads waits. So the least times are nearest to those of an undisturbed program.
function print_chart(section,    r, p, row, parts, program, alone, key, speedup, marks, shown) {
    for (r = 1; r <= section_rows[section]; r++)
        for (p = 1; p <= section_programs[section]; p++) {
            row = row_list[section, r]
            program = program_list[section, p]
            key = section SUBSEP row SUBSEP program
            split(program, parts, "/")
            alone = section SUBSEP row SUBSEP parts[1]
            if (!(alone in walls))
                alone = alone "/j1"
            if (program !~ /\/[kjx][0-9]/ || key == alone || !(key in walls) || !(alone in walls))
                continue
            if (!shown++)
                print "\nSpeed-up over one job, undivided: median over rounds (# is 0.05), ratio of the least times:\n\n```"
            speedup = paired(walls[alone], walls[key])
            marks = ""
            while (length(marks) < int(20 * speedup + 0.5))
                marks = marks "#"
            split(row, parts, "|")
            printf "%-10s %8d  %-16s %5.2f %5.2f %s\n", parts[1], parts[2], program, speedup, \
                least(walls[alone]) / least(walls[key]), marks
        }
    if (shown)
        print "```"
}

END {
    printf "- one-thread runs whose wall time exceeded their CPU time by more than 5 %% (a busy machine): %d of %d\n", \
        delayed, single
    print "- !: the cells differ from the reference's; -: not run; nn: without neighbours; kK: K regions; jJ: J threads;"
    print "  xC: C concurrent processes, each with 1/C of the points: what C processors achieve if no process waits"
    for (s = 1; s <= sections; s++) {
        section = section_list[s]
        print "\n## " section
        print "\nTime divided by the reference's, median over pairs:\n"
        print_section(section, "ratio")
        print "\nNanoseconds per cell:\n"
        print_section(section, "time")
        if (largest_uniform && (section == "families" || section == "sizes")) {
            printf "\nTime per cell divided by the same program's on %d uniform points:\n\n", largest_uniform
            print_section(section, "relative")
        }
        if (section != "small") {
            print "\nBytes per point, including the result, without the input:\n"
            print_section(section, "memory")
        }
        print_chart(section)
    }
}
